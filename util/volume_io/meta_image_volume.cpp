#include "volume_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include "data_files.h"
#include "input_file.h"
#include "printable_text.h"

namespace vo {
namespace {

constexpr std::int64_t kLongestHeader = 1 << 20;

/// The fields of a header, `Key = value` a line, the last one ElementDataFile.
struct MetaHeader
{
    std::string path;
    std::map<std::string, std::string> fields;
    std::vector<std::string> listed; // file names after ElementDataFile = LIST
    std::int64_t length = 0;

    /// The first of these fields that is there, or "".
    std::string field(std::initializer_list<const char*> names) const
    {
        for (const char* name : names)
            if (const auto found = fields.find(name); found != fields.end()) return found->second;
        return "";
    }
    bool isTrue(std::initializer_list<const char*> names) const
    {
        const std::string value = field(names);
        return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
    }
};

std::string trimmed(const std::string& text)
{
    const char* blanks = " \t\r";
    const auto first = text.find_first_not_of(blanks);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

Result<MetaHeader> readHeader(const InputFile& file)
{
    std::string text(static_cast<std::size_t>(std::min(file.size(), kLongestHeader)), '\0');
    if (auto read = file.readAt(0, std::as_writable_bytes(std::span(text))); !read) return read.failure();
    MetaHeader header;
    header.path = file.path();
    for (std::size_t at = 0; at < text.size();) {
        const auto end = text.find('\n', at);
        const std::string line = text.substr(at, end - at);
        at = end == std::string::npos ? text.size() : end + 1;
        const auto equals = line.find('=');
        if (equals == std::string::npos) continue;
        const std::string key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
        header.fields[key] = value;
        if (key != "ElementDataFile") continue;
        header.length = static_cast<std::int64_t>(at);
        if (value.starts_with("LIST")) {
            std::istringstream lines(text.substr(at));
            for (std::string name; std::getline(lines, name);)
                if (!trimmed(name).empty()) header.listed.push_back(trimmed(name));
        }
        return header;
    }
    return Failure{file.path() +
                   ": cut off: expected a line ElementDataFile in the MetaImage header, found " +
                   std::to_string(header.fields.size()) + " other fields"};
}

/// The numbers of a field; a failure unless there are `count` of them.
template <class Number>
Result<std::vector<Number>> numbers(const MetaHeader& header, const char* name, const std::string& value,
                                    std::size_t count)
{
    std::vector<Number> found;
    std::istringstream words(value);
    for (std::string word; words >> word;) {
        Number number{};
        const auto parsed = std::from_chars(word.data(), word.data() + word.size(), number);
        if (parsed.ec != std::errc() || parsed.ptr != word.data() + word.size()) break;
        found.push_back(number);
    }
    if (found.size() >= count) return found;
    return Failure{header.path + ": expected " + std::to_string(count) + " numbers in the field " + name +
                   ", found \"" + printable(value) + "\""};
}

Result<std::int64_t> number(const MetaHeader& header, const char* name, std::int64_t otherwise)
{
    const std::string value = header.field({name});
    if (value.empty()) return otherwise;
    const auto found = numbers<std::int64_t>(header, name, value, 1);
    if (!found) return found.failure();
    return (*found)[0];
}

std::optional<StoredType> storedType(const std::string& name)
{
    static const std::map<std::string, StoredType> types{
        {"MET_CHAR", StoredType::int8},       {"MET_UCHAR", StoredType::uint8},
        {"MET_SHORT", StoredType::int16},     {"MET_USHORT", StoredType::uint16},
        {"MET_INT", StoredType::int32},       {"MET_UINT", StoredType::uint32},
        {"MET_LONG", StoredType::int32},      {"MET_ULONG", StoredType::uint32},
        {"MET_LONG_LONG", StoredType::int64}, {"MET_ULONG_LONG", StoredType::uint64},
        {"MET_FLOAT", StoredType::float32},   {"MET_DOUBLE", StoredType::float64},
    };
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

Result<StoredLayout> layoutOf(const MetaHeader& header, std::int64_t& volumes)
{
    const auto dimensions = number(header, "NDims", 3);
    if (!dimensions) return dimensions.failure();
    if (*dimensions < 1 || *dimensions > 4)
        return Failure{header.path + ": expected 1 to 4 dimensions, found " + std::to_string(*dimensions)};
    const auto sizes = numbers<std::int64_t>(header, "DimSize", header.field({"DimSize"}),
                                             static_cast<std::size_t>(*dimensions));
    if (!sizes) return sizes.failure();
    StoredLayout layout;
    layout.size = {1, 1, 1};
    for (std::size_t i = 0; i < static_cast<std::size_t>(*dimensions) && i < 3; ++i)
        layout.size[i] = (*sizes)[i];
    volumes = *dimensions == 4 ? (*sizes)[3] : 1;
    if (volumes < 1)
        return Failure{header.path + ": expected at least one volume, found " + std::to_string(volumes)};

    const std::string name = header.field({"ElementType"});
    const auto type = storedType(name);
    if (!type)
        return Failure{header.path + ": expected an ElementType of numbers, found \"" + printable(name) +
                       "\""};
    layout.type = *type;
    const auto channels = number(header, "ElementNumberOfChannels", 1);
    if (!channels) return channels.failure();
    layout.channels = static_cast<int>(std::clamp<std::int64_t>(*channels, -1, 1000));
    layout.byteOrder = header.isTrue({"ElementByteOrderMSB", "BinaryDataByteOrderMSB"})
                           ? ByteOrder::bigEndian
                           : ByteOrder::littleEndian;
    return layout;
}

bool isDistance(double value)
{
    return std::isfinite(value) && value > 0;
}

bool isDistanceOrItsNegative(double value)
{
    return isDistance(std::abs(value));
}

/// Unit vectors along the axes in the frame left, back, up; none where the file does not say. The letters of
/// AnatomicalOrientation tell where axes come from, not where they lead.
std::optional<std::array<Vector3, 3>> directions(const MetaHeader& header)
{
    const std::string letters = header.field({"AnatomicalOrientation"});
    const std::string matrix = header.field({"TransformMatrix", "Rotation", "Orientation"});
    std::array<Vector3, 3> axes{};
    if (letters.find('?') != std::string::npos) return std::nullopt;
    if (!matrix.empty()) {
        const auto found = numbers<double>(header, "TransformMatrix", matrix, 9);
        if (!found || found->size() != 9) return std::nullopt;
        for (std::size_t i = 0; i < 9; ++i)
            axes[i / 3][i % 3] = (*found)[i];
        return axes;
    }
    if (letters.size() != 3) return std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto place = std::string("RLAPIS").find(letters[axis]);
        if (place == std::string::npos) return std::nullopt;
        axes[axis][place / 2] = place % 2 == 0 ? 1 : -1;
    }
    return axes;
}

Placement placementOf(const MetaHeader& header, std::vector<std::string>& notes)
{
    Vector3 spacing{std::nan(""), 1, 1};
    const std::string value = header.field({"ElementSpacing", "ElementSize"});
    if (const auto found = numbers<double>(header, "ElementSpacing", value, 1))
        for (std::size_t i = 0; i < 3 && i < found->size(); ++i)
            spacing[i] = (*found)[i];
    if (!value.empty() && !std::ranges::all_of(spacing, isDistance))
        notes.push_back(
            "expected an ElementSpacing of numbers above 0, found \"" + printable(value) + "\"; " +
            (std::ranges::all_of(spacing, isDistanceOrItsNegative) ? "signs are" : "it is") + " not used");
    for (double& distance : spacing)
        distance = std::abs(distance);
    const Placement unturned = fileOrder(spacing);
    const auto axes = directions(header);
    if (!axes) return unturned;
    std::array<Vector3, 3> steps{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        steps[axis] = fromLeftBackUp((*axes)[axis]);
        for (double& part : steps[axis])
            part *= unturned.spacing[axis];
    }
    auto placement = placementOfSteps(steps);
    if (!placement) return unturned;
    placement->spacingKnown = unturned.spacingKnown;
    return *placement;
}

Result<DataFiles> dataFilesOf(const MetaHeader& header)
{
    DataFiles data;
    const std::string name = header.field({"ElementDataFile"});
    if (name == "LOCAL" || name == "Local" || name == "local") {
        data.paths = {header.path};
        data.firstByte = header.length;
    } else if (name.starts_with("LIST")) {
        data.paths = besideHeader(header.path, header.listed);
    } else {
        const auto names = namedFiles(header.path, name);
        if (!names) return names.failure();
        data.paths = besideHeader(header.path, *names);
    }
    if (name.empty() || data.paths.empty())
        return Failure{header.path + ": expected the names of data files, found none"};
    const bool isText = header.fields.contains("BinaryData") && !header.isTrue({"BinaryData"});
    data.encoding = header.isTrue({"CompressedData"}) ? Encoding::deflate
                    : isText                          ? Encoding::text
                                                      : Encoding::raw;
    const auto skip = number(header, "HeaderSize", 0);
    if (!skip) return skip.failure();
    if (*skip < (data.encoding == Encoding::raw ? -1 : 0) || *skip > INT64_MAX / 2)
        return Failure{header.path + ": expected a HeaderSize of 0 or more, found " + std::to_string(*skip)};
    // Before compressed voxels the bytes are those of the file.
    (data.encoding == Encoding::deflate ? data.firstByte : data.byteSkip) += *skip;
    return data;
}

} // namespace

Result<VolumeFile> openMetaImageVolume(const std::string& path)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    const auto header = readHeader(*file);
    if (!header) return header.failure();
    std::int64_t volumes = 1;
    auto layout = layoutOf(*header, volumes);
    if (!layout) return layout.failure();
    const auto bytes = storedBytes(path, *layout);
    if (!bytes) return bytes.failure();
    const auto data = dataFilesOf(*header);
    if (!data) return data.failure();
    if (data->encoding == Encoding::text) layout->byteOrder = nativeByteOrder();
    auto source = openDataFiles(path, *data, layout->type, *bytes, volumes);
    if (!source) return source.failure();

    VolumeDescription about;
    about.format = "MetaImage";
    if (volumes > 1) about.notes.push_back("the first of " + std::to_string(volumes) + " volumes is read");
    const Placement placement = placementOf(*header, about.notes);
    return openStoredVoxels(*layout, placement, std::move(*source), std::move(about));
}

} // namespace vo
