#include "volume_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <mutex>
#include <optional>
#include <sstream>
#include <string_view>
#include <teem/nrrd.h>

#include "data_files.h"
#include "input_file.h"
#include "printable_text.h"

namespace vo {
namespace {

constexpr std::int64_t kLongestHeader = 1 << 20;

/// The header's lines, and what they say about files. teem gets them without that, since it would open the
/// files at once.
struct HeaderText
{
    std::string lines;
    std::int64_t length = 0; // up to the voxels behind the empty line
    bool isAttached = false; // there is an empty line
    bool hasSizes = false;
    std::vector<std::string> files;
};

std::string trimmed(const std::string& text)
{
    const char* blanks = " \t\r";
    const auto first = text.find_first_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// A line `NAME: ...`, its name in small letters; "" for any other.
struct HeaderField
{
    std::string name, value;

    bool isDataFile() const { return name == "data file" || name == "datafile"; }
};

HeaderField fieldOf(const std::string& line)
{
    const auto colon = line.find(':');
    if (line.starts_with('#') || colon == std::string::npos || line.compare(colon, 2, ":=") == 0) return {};
    std::string name = trimmed(line.substr(0, colon));
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return {name, trimmed(line.substr(colon + 1))};
}

/// teem takes a size that is no whole number for one of 0, or for the whole part of it.
Result<void> checkSizes(const std::string& path, int line, const std::string& field)
{
    const std::string place = path + ":" + std::to_string(line) + ": sizes: expected ";
    std::istringstream words(field);
    std::int64_t all = 1;
    for (std::string word; words >> word;) {
        std::int64_t size = 0;
        const char* const end = word.data() + word.size();
        const auto parsed = std::from_chars(word.data(), end, size);
        if (parsed.ec != std::errc() || parsed.ptr != end || size < 1)
            return Failure{place + "whole numbers from 1 on, found \"" + printable(word, 40) + "\""};
        if (__builtin_mul_overflow(all, size, &all))
            return Failure{place + "fewer than 2^63 numbers in all, found \"" + printable(field, 80) + "\""};
    }
    return {};
}

Result<HeaderText> readHeaderText(const InputFile& file)
{
    std::string text(static_cast<std::size_t>(std::min(file.size(), kLongestHeader)), '\0');
    if (auto read = file.readAt(0, std::as_writable_bytes(std::span(text))); !read) return read.failure();
    HeaderText header;
    bool isList = false;
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
        ++number;
        const auto end = text.find('\n', at);
        if (end == std::string::npos && file.size() > kLongestHeader)
            return Failure{file.path() + ": expected an empty line after a NRRD header of at most " +
                           std::to_string(kLongestHeader) + " bytes, found none"};
        const std::string line = text.substr(at, end - at);
        at = end == std::string::npos ? text.size() : end + 1;
        if (isList) {
            if (const std::string name = trimmed(line); !name.empty()) header.files.push_back(name);
            continue;
        }
        if (line.empty() || line == "\r") {
            header.isAttached = true;
            header.length = static_cast<std::int64_t>(at);
            break;
        }
        const HeaderField field = fieldOf(line);
        header.hasSizes = header.hasSizes || field.name == "sizes";
        if (field.name == "sizes")
            if (auto fit = checkSizes(file.path(), number, field.value); !fit) return fit.failure();
        if (!field.isDataFile()) {
            header.lines += line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
            header.lines += '\n';
        } else if (field.value.starts_with("LIST")) {
            isList = true;
        } else {
            auto files = namedFiles(file.path(), field.value);
            if (!files) return files.failure();
            header.files = std::move(*files);
        }
    }
    if (header.isAttached ? header.files.empty() : !header.files.empty()) return header;
    if (header.isAttached) {
        header.isAttached = false; // voxels elsewhere, whatever follows the empty line
        return header;
    }
    return Failure{file.path() +
                   ": expected an empty line before the voxels, or a \"data file:\" line, found neither"};
}

struct FreeNrrd
{
    void operator()(Nrrd* nrrd) const { nrrdNuke(nrrd); }
    void operator()(NrrdIoState* state) const { nrrdIoStateNix(state); }
};

struct Parsed
{
    std::unique_ptr<Nrrd, FreeNrrd> nrrd;
    std::unique_ptr<NrrdIoState, FreeNrrd> state;
};

/// Whether the first line is one that teem knows.
bool hasKnownMagic(const std::string& lines)
{
    const std::string first = lines.substr(0, lines.find('\n'));
    return first.size() == 8 && first.starts_with("NRRD000") && first[7] >= '1' && first[7] <= '5';
}

/// What teem makes of the header. Its error log is the process's, so one thread at a time.
Result<Parsed> parse(const std::string& path, const HeaderText& header)
{
    if (!hasKnownMagic(header.lines))
        return Failure{path + ": expected a first line from NRRD0001 to NRRD0005, found \"" +
                       printable(header.lines.substr(0, header.lines.find('\n')), 12) + "\""};
    if (!header.hasSizes)
        return Failure{path + ": expected a line \"sizes: ...\" in the NRRD header, found none"};
    static std::mutex one;
    const std::lock_guard guard(one);
    Parsed parsed{std::unique_ptr<Nrrd, FreeNrrd>(nrrdNew()),
                  std::unique_ptr<NrrdIoState, FreeNrrd>(nrrdIoStateNew())};
    parsed.state->skipData = 1;
    // teem takes a string's end for the end of the header.
    const std::string text = header.lines + "\n";
    if (nrrdStringRead(parsed.nrrd.get(), text.c_str(), parsed.state.get()) == 0) return parsed;
    std::string why;
    if (char* log = biffGetDone(NRRD)) {
        // The last line is the innermost reason.
        why = log;
        std::free(log);
        while (why.ends_with('\n'))
            why.pop_back();
        why = why.substr(why.rfind('\n') + 1);
        if (why.starts_with("[nrrd] ")) why.erase(0, 7);
        if (why.starts_with("_nrrd") && why.find(": ") != std::string::npos) why.erase(0, why.find(": ") + 2);
        why = printable(why, 160);
    }
    return Failure{path + ": expected a NRRD header, found one that cannot be read: " + why};
}

std::optional<StoredType> storedType(int type)
{
    switch (type) {
    case nrrdTypeChar: return StoredType::int8;
    case nrrdTypeUChar: return StoredType::uint8;
    case nrrdTypeShort: return StoredType::int16;
    case nrrdTypeUShort: return StoredType::uint16;
    case nrrdTypeInt: return StoredType::int32;
    case nrrdTypeUInt: return StoredType::uint32;
    case nrrdTypeLLong: return StoredType::int64;
    case nrrdTypeULLong: return StoredType::uint64;
    case nrrdTypeFloat: return StoredType::float32;
    case nrrdTypeDouble: return StoredType::float64;
    default: return std::nullopt;
    }
}

/// The axes of space and what the other one, if any, is.
struct Axes
{
    std::vector<unsigned> space; // 1 to 3 of them, fastest first
    int channels = 1;
    bool planar = false;
    std::int64_t volumes = 1;
};

bool isInSpace(const NrrdAxisInfo& axis)
{
    return axis.kind == nrrdKindDomain || axis.kind == nrrdKindSpace ||
           (axis.kind == nrrdKindUnknown &&
            (std::isfinite(axis.spaceDirection[0]) || std::isfinite(axis.spacing)));
}

bool holdsChannels(int kind)
{
    return kind != nrrdKindTime && kind != nrrdKindList && kind != nrrdKindDomain && kind != nrrdKindSpace;
}

Result<Axes> axesOf(const std::string& path, const Nrrd& nrrd)
{
    Axes axes;
    if (nrrd.dim < 1 || nrrd.dim > 4)
        return Failure{path + ": expected 1 to 4 dimensions, found " + std::to_string(nrrd.dim)};
    // The axis that is not of space: of four always one, of fewer where its kind says so.
    std::optional<unsigned> other;
    for (unsigned i = 0; i < nrrd.dim && !other; ++i)
        if (nrrd.axis[i].kind != nrrdKindUnknown && !isInSpace(nrrd.axis[i])) other = i;
    if (nrrd.dim == 4 && !other) {
        const bool first = !isInSpace(nrrd.axis[0]) && (isInSpace(nrrd.axis[3]) || nrrd.axis[0].size <= 4);
        other = first ? 0 : 3;
    }
    for (unsigned i = 0; i < nrrd.dim; ++i)
        if (i != other) axes.space.push_back(i);
    if (!other) return axes;
    const NrrdAxisInfo& axis = nrrd.axis[*other];
    const bool isLast = *other == nrrd.dim - 1, isFirst = *other == 0;
    if (!isFirst && !isLast)
        return Failure{path + ": expected channels as the first or the last axis, found them as axis " +
                       std::to_string(*other)};
    if (isLast && !(holdsChannels(axis.kind) && axis.kind != nrrdKindUnknown && axis.size <= 4)) {
        axes.volumes = static_cast<std::int64_t>(axis.size);
        return axes;
    }
    if (axis.size > 4)
        return Failure{path + ": expected 1 to 4 channels, found " + std::to_string(axis.size)};
    axes.channels = static_cast<int>(axis.size);
    axes.planar = isLast && !isFirst;
    return axes;
}

/// Millimetres in a unit of length; 1 for one that is unknown or not there.
double millimetresIn(const char* unit)
{
    const std::pair<const char*, double> units[] = {{"nm", 1e-6},      {"um", 1e-3}, {"micron", 1e-3},
                                                    {"microns", 1e-3}, {"cm", 10},   {"m", 1e3}};
    for (const auto& [name, millimetres] : units)
        if (unit && std::string_view(unit) == name) return millimetres;
    return 1;
}

Placement placementOf(const Nrrd& nrrd, const Axes& axes)
{
    const bool isPatient = nrrd.space == nrrdSpaceRightAnteriorSuperior ||
                           nrrd.space == nrrdSpaceLeftAnteriorSuperior ||
                           nrrd.space == nrrdSpaceLeftPosteriorSuperior;
    std::array<Vector3, 3> steps{};
    Vector3 spacing{1, 1, 1};
    bool hasSpacing = false;
    for (std::size_t i = 0; i < axes.space.size(); ++i) {
        const NrrdAxisInfo& axis = nrrd.axis[axes.space[i]];
        const double* direction = axis.spaceDirection;
        const double length = nrrd.spaceDim == 2 ? std::hypot(direction[0], direction[1])
                                                 : std::hypot(direction[0], direction[1], direction[2]);
        spacing[i] = std::isfinite(length) ? length * millimetresIn(nrrd.spaceUnits[0])
                                           : std::abs(axis.spacing) * millimetresIn(axis.units);
        hasSpacing = hasSpacing || std::isfinite(spacing[i]);
        if (!std::isfinite(spacing[i])) spacing[i] = 1;
        const bool xLeft = nrrd.space != nrrdSpaceRightAnteriorSuperior;
        const bool yBack = nrrd.space == nrrdSpaceLeftPosteriorSuperior;
        steps[i] = {xLeft ? -direction[0] : direction[0], yBack ? -direction[1] : direction[1], direction[2]};
        for (double& part : steps[i])
            part *= millimetresIn(nrrd.spaceUnits[0]);
    }
    if (isPatient && axes.space.size() == 3)
        if (const auto found = placementOfSteps(steps)) return *found;
    Placement placement = fileOrder(spacing);
    placement.spacingKnown = placement.spacingKnown && hasSpacing;
    return placement;
}

/// How the voxels are written down; none for what is not read.
std::optional<Encoding> encodingOf(const NrrdEncoding* encoding)
{
    if (encoding == nrrdEncodingRaw) return Encoding::raw;
    if (encoding == nrrdEncodingGzip) return Encoding::deflate;
    if (encoding == nrrdEncodingAscii) return Encoding::text;
    if (encoding == nrrdEncodingHex) return Encoding::hex;
    return std::nullopt;
}

Result<DataFiles> dataFilesOf(const std::string& path, const HeaderText& header, const NrrdIoState& state)
{
    const auto encoding = encodingOf(state.encoding);
    if (!encoding)
        return Failure{path + ": expected the encoding raw, gzip, ascii or hex, found \"" +
                       state.encoding->name + "\""};
    DataFiles data;
    data.encoding = *encoding;
    data.lineSkip = state.lineSkip;
    data.byteSkip = state.byteSkip;
    if (data.byteSkip < (data.encoding == Encoding::raw ? -1 : 0))
        return Failure{path + ": expected a byte skip of 0 or more, found " + std::to_string(data.byteSkip)};
    if (header.isAttached) {
        data.paths = {path};
        data.firstByte = header.length;
    } else {
        data.paths = besideHeader(path, header.files);
    }
    return data;
}

Result<StoredLayout> layoutOf(const std::string& path, const Nrrd& nrrd, const Axes& axes, int endian)
{
    const auto type = storedType(nrrd.type);
    if (!type)
        return Failure{path + ": expected numbers, found the NRRD type \"" + airEnumStr(nrrdType, nrrd.type) +
                       "\""};
    StoredLayout layout;
    layout.size = {1, 1, 1};
    for (std::size_t i = 0; i < axes.space.size(); ++i)
        layout.size[i] = static_cast<std::int64_t>(
            std::min<std::size_t>(nrrd.axis[axes.space[i]].size, std::size_t(INT64_MAX)));
    layout.channels = axes.channels;
    layout.planar = axes.planar;
    layout.type = *type;
    if (endian != airEndianUnknown)
        layout.byteOrder = endian == airEndianBig ? ByteOrder::bigEndian : ByteOrder::littleEndian;
    return layout;
}

} // namespace

Result<VolumeFile> openNrrdVolume(const std::string& path)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    const auto header = readHeaderText(*file);
    if (!header) return header.failure();
    const auto parsed = parse(path, *header);
    if (!parsed) return parsed.failure();
    const Nrrd& nrrd = *parsed->nrrd;
    const auto axes = axesOf(path, nrrd);
    if (!axes) return axes.failure();
    auto layout = layoutOf(path, nrrd, *axes, parsed->state->endian);
    if (!layout) return layout.failure();
    const auto bytes = storedBytes(path, *layout);
    if (!bytes) return bytes.failure();

    VolumeDescription about;
    about.format = "NRRD";
    if (axes->volumes > 1)
        about.notes.push_back("the first of " + std::to_string(axes->volumes) + " volumes is read");
    const auto data = dataFilesOf(path, *header, *parsed->state);
    if (!data) return data.failure();
    if (data->encoding == Encoding::text) layout->byteOrder = nativeByteOrder();
    auto source = openDataFiles(path, *data, layout->type, *bytes, axes->volumes);
    if (!source) return source.failure();
    return openStoredVoxels(*layout, placementOf(nrrd, *axes), std::move(*source), std::move(about));
}

} // namespace vo
