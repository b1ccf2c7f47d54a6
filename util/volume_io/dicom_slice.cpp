#include "dicom_slice.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <gdcmAttribute.h>
#include <gdcmImageReader.h>
#include <gdcmMediaStorage.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include "byte_order.h"
#include "isolated_process.h"
#include "printable_text.h"

namespace vo {
namespace {

const gdcm::Tag kPixelData(0x7fe0, 0x0010);

void silenceLibrary()
{
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
}

/// A text element without padding, or "".
std::string text(const gdcm::DataSet& set, const gdcm::Tag& tag)
{
    if (!set.FindDataElement(tag)) return "";
    const gdcm::ByteValue* value = set.GetDataElement(tag).GetByteValue();
    if (!value || !value->GetPointer()) return "";
    std::string found(value->GetPointer(), value->GetLength());
    found.resize(std::min(found.find('\0'), found.size()));
    while (found.ends_with(' '))
        found.pop_back();
    std::ranges::replace_if(
        found, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '.');
    return found;
}

/// The numbers of a text element, separated by backslashes.
std::vector<double> decimals(const gdcm::DataSet& set, const gdcm::Tag& tag)
{
    std::vector<double> values;
    std::string all = text(set, tag);
    for (const char* at = all.c_str(); *at;) {
        char* end = nullptr;
        values.push_back(std::strtod(at, &end));
        if (end == at) return {};
        while (*end == ' ')
            ++end;
        if (*end && *end != '\\') return {};
        at = *end ? end + 1 : end;
    }
    return values;
}

double decimal(const gdcm::DataSet& set, const gdcm::Tag& tag, double otherwise)
{
    const auto values = decimals(set, tag);
    return values.empty() || !std::isfinite(values[0]) ? otherwise : values[0];
}

/// An unsigned short, or `otherwise` where there is none.
template <std::uint16_t Group, std::uint16_t Element>
int number(const gdcm::DataSet& set, int otherwise)
{
    const gdcm::Tag tag(Group, Element);
    if (!set.FindDataElement(tag)) return otherwise;
    const gdcm::ByteValue* value = set.GetDataElement(tag).GetByteValue();
    if (!value || value->GetLength() < 2) return otherwise;
    gdcm::Attribute<Group, Element> attribute;
    attribute.SetFromDataElement(set.GetDataElement(tag));
    return static_cast<int>(attribute.GetValue());
}

/// Runs `read`, whose exceptions become failures.
template <class Read>
auto guarded(const std::string& path, Read read) -> decltype(read())
{
    silenceLibrary();
    try {
        return read();
    } catch (const std::bad_alloc&) {
        return Failure{path + ": expected enough memory for its elements, found less"};
    } catch (const std::exception& exception) {
        return Failure{path + ": expected a DICOM file, found a damaged one: " + printable(exception.what())};
    }
}

void readPlace(const gdcm::DataSet& set, DicomSlice& slice)
{
    const auto directions = decimals(set, gdcm::Tag(0x0020, 0x0037));
    if (directions.size() == 6)
        slice.directions = {Vector3{directions[0], directions[1], directions[2]},
                            Vector3{directions[3], directions[4], directions[5]}};
    const auto position = decimals(set, gdcm::Tag(0x0020, 0x0032));
    if (position.size() == 3) slice.position = Vector3{position[0], position[1], position[2]};
    auto spacing = decimals(set, gdcm::Tag(0x0028, 0x0030));
    if (spacing.size() != 2) spacing = decimals(set, gdcm::Tag(0x0018, 0x1164)); // of the detector
    if (spacing.size() == 2) slice.spacing = {spacing[1], spacing[0]};           // the file has rows first
    slice.sliceSpacing = decimal(set, gdcm::Tag(0x0018, 0x0088), 0);
    if (!(slice.sliceSpacing > 0)) slice.sliceSpacing = decimal(set, gdcm::Tag(0x0018, 0x0050), 0);
}

/// Of enhanced files, whose frames say these things in sequences, GDCM knows where.
void readPlaceOfFrames(const std::string& path, DicomSlice& slice)
{
    gdcm::ImageReader reader;
    reader.SetFileName(path.c_str());
    if (!reader.Read()) return;
    const gdcm::Image& image = reader.GetImage();
    const double* cosines = image.GetDirectionCosines();
    const double* origin = image.GetOrigin();
    if (!slice.directions && cosines)
        slice.directions = {Vector3{cosines[0], cosines[1], cosines[2]},
                            Vector3{cosines[3], cosines[4], cosines[5]}};
    if (!slice.position && origin) slice.position = Vector3{origin[0], origin[1], origin[2]};
    if (!(slice.spacing[0] > 0)) slice.spacing = {image.GetSpacing(0), image.GetSpacing(1)};
    if (image.GetNumberOfDimensions() > 2 && image.GetSpacing(2) > 0)
        slice.sliceSpacing = image.GetSpacing(2);
    slice.slope = image.GetSlope();
    slice.intercept = image.GetIntercept();
}

Result<void> readShape(const gdcm::File& file, DicomSlice& slice)
{
    const gdcm::DataSet& set = file.GetDataSet();
    slice.columns = number<0x0028, 0x0011>(set, 0);
    slice.rows = number<0x0028, 0x0010>(set, 0);
    slice.frames = static_cast<std::int64_t>(decimal(set, gdcm::Tag(0x0028, 0x0008), 1));
    slice.channels = number<0x0028, 0x0002>(set, 1);
    slice.bitsAllocated = number<0x0028, 0x0100>(set, 0);
    slice.bitsStored = number<0x0028, 0x0101>(set, slice.bitsAllocated);
    slice.highBit = number<0x0028, 0x0102>(set, slice.bitsStored - 1);
    slice.isSigned = number<0x0028, 0x0103>(set, 0) == 1;
    const std::string colours = text(set, gdcm::Tag(0x0028, 0x0004));
    slice.lowIsWhite = colours == "MONOCHROME1";
    slice.isCompressed = file.GetHeader().GetDataSetTransferSyntax().IsEncapsulated();
    if (slice.frames < 1 || slice.frames > 0x7fffffff)
        return Failure{slice.path + ": expected at least one frame, found " + std::to_string(slice.frames)};
    const bool isGrey = slice.channels == 1 && (colours == "MONOCHROME1" || colours == "MONOCHROME2");
    // What JPEG keeps as YBR, GDCM decodes to RGB.
    const bool isColour =
        slice.channels == 3 && (colours == "RGB" || (slice.isCompressed && colours.starts_with("YBR_")));
    if (!isGrey && !isColour)
        return Failure{slice.path + ": expected grey or RGB pixels, found " + std::to_string(slice.channels) +
                       " channels of \"" + printable(colours) + "\""};
    const bool isKnown = slice.bitsAllocated == 8 || slice.bitsAllocated == 16 || slice.bitsAllocated == 32;
    if (!isKnown || slice.bitsStored < 1 || slice.bitsStored > slice.bitsAllocated ||
        slice.highBit >= slice.bitsAllocated || slice.highBit < slice.bitsStored - 1)
        return Failure{slice.path + ": expected pixels of 8, 16 or 32 bits, found " +
                       std::to_string(slice.bitsStored) + " of " + std::to_string(slice.bitsAllocated) +
                       " bits up to bit " + std::to_string(slice.highBit)};
    return {};
}

DicomHeader headerOf(const std::string& path)
{
    gdcm::Reader reader;
    reader.SetFileName(path.c_str());
    // Pixels are passed over here, and what follows them is never looked at.
    if (!reader.ReadUpToTag(gdcm::Tag(0x0029, 0x0000), {kPixelData})) return std::optional<DicomSlice>();
    const gdcm::DataSet& set = reader.GetFile().GetDataSet();
    if (number<0x0028, 0x0010>(set, 0) == 0) return std::optional<DicomSlice>(); // no picture
    DicomSlice slice;
    slice.path = path;
    slice.series = text(set, gdcm::Tag(0x0020, 0x000e));
    slice.seriesDescription = text(set, gdcm::Tag(0x0008, 0x103e));
    slice.instance =
        static_cast<std::int64_t>(std::clamp(decimal(set, gdcm::Tag(0x0020, 0x0013), 0), -1e15, 1e15));
    if (auto read = readShape(reader.GetFile(), slice); !read) return read.failure();
    const double slope = decimal(set, gdcm::Tag(0x0028, 0x1053), 1);
    slice.slope = slope != 0 ? slope : 1;
    slice.intercept = decimal(set, gdcm::Tag(0x0028, 0x1052), 0);
    readPlace(set, slice);
    gdcm::MediaStorage kind;
    kind.SetFromFile(reader.GetFile());
    if (kind == gdcm::MediaStorage::EnhancedMRImageStorage ||
        kind == gdcm::MediaStorage::EnhancedCTImageStorage ||
        kind == gdcm::MediaStorage::EnhancedPETImageStorage)
        readPlaceOfFrames(path, slice);
    return std::optional(slice);
}

/// Moves the bits of a value down to the lowest and sets those above it to 0 or the sign.
template <class Number>
void keepStoredBits(const DicomSlice& slice, std::span<std::byte> bytes)
{
    const int drop = 8 * int(sizeof(Number)) - 1 - slice.highBit;
    const int shift = 8 * int(sizeof(Number)) - slice.bitsStored;
    using Unsigned = std::make_unsigned_t<Number>;
    for (std::size_t i = 0; i + sizeof(Number) <= bytes.size(); i += sizeof(Number)) {
        Unsigned value;
        std::memcpy(&value, &bytes[i], sizeof value);
        const auto high = static_cast<Number>(static_cast<Unsigned>(value << drop));
        const auto kept = static_cast<Number>(high >> shift);
        std::memcpy(&bytes[i], &kept, sizeof kept);
    }
}

void keepStoredBits(const DicomSlice& slice, std::span<std::byte> bytes)
{
    if (slice.bitsStored == slice.bitsAllocated) return;
    switch (slice.bitsAllocated) {
    case 8:
        return slice.isSigned ? keepStoredBits<std::int8_t>(slice, bytes)
                              : keepStoredBits<std::uint8_t>(slice, bytes);
    case 16:
        return slice.isSigned ? keepStoredBits<std::int16_t>(slice, bytes)
                              : keepStoredBits<std::uint16_t>(slice, bytes);
    default:
        return slice.isSigned ? keepStoredBits<std::int32_t>(slice, bytes)
                              : keepStoredBits<std::uint32_t>(slice, bytes);
    }
}

/// Puts the channels of a pixel side by side where each frame has them one after another.
void interleave(const DicomSlice& slice, std::span<std::byte> bytes)
{
    const auto pixels = static_cast<std::size_t>(slice.columns * slice.rows);
    const auto channels = static_cast<std::size_t>(slice.channels);
    const auto size = static_cast<std::size_t>(slice.bitsAllocated / 8);
    const std::size_t frameBytes = pixels * channels * size;
    std::vector<std::byte> planes(frameBytes);
    for (std::size_t frame = 0; frame < static_cast<std::size_t>(slice.frames); ++frame) {
        std::byte* const out = bytes.data() + frame * frameBytes;
        std::memcpy(planes.data(), out, frameBytes);
        for (std::size_t channel = 0; channel < channels; ++channel)
            for (std::size_t pixel = 0; pixel < pixels; ++pixel)
                std::memcpy(out + (pixel * channels + channel) * size,
                            &planes[(channel * pixels + pixel) * size], size);
    }
}

Failure tooFewPixels(const DicomSlice& slice, std::size_t expected, std::size_t found)
{
    return {slice.path + ": cut off or damaged: expected " + std::to_string(expected) +
            " bytes of pixels, found " + std::to_string(found)};
}

std::uintmax_t bytesIn(const std::string& path)
{
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    return error ? 0 : bytes;
}

/// Bytes of a file from the first of its pixels on, which GDCM, asked to pass over them, stops at.
std::size_t bytesFromPixelsOn(const std::string& path)
{
    gdcm::Reader reader;
    reader.SetFileName(path.c_str());
    if (!reader.ReadUpToTag(kPixelData, {kPixelData})) return 0;
    const std::uintmax_t start = reader.GetStreamCurrentPosition(), end = bytesIn(path);
    return start < end ? static_cast<std::size_t>(end - start) : 0;
}

Result<void> readPlainPixels(const DicomSlice& slice, std::span<std::byte> out)
{
    gdcm::Reader reader;
    reader.SetFileName(slice.path.c_str());
    if (!reader.ReadUpToTag(kPixelData)) return tooFewPixels(slice, out.size(), 0);
    const gdcm::DataSet& set = reader.GetFile().GetDataSet();
    const gdcm::ByteValue* value =
        set.FindDataElement(kPixelData) ? set.GetDataElement(kPixelData).GetByteValue() : nullptr;
    const std::size_t claimed = value && value->GetPointer() ? std::size_t(value->GetLength()) : 0;
    // What a file that is cut off lacks, GDCM hands over as zeros. Deflated files it refuses itself.
    const gdcm::TransferSyntax& syntax = reader.GetFile().GetHeader().GetDataSetTransferSyntax();
    const bool isDeflated = syntax == gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian;
    const std::size_t found = isDeflated ? claimed : std::min(claimed, bytesFromPixelsOn(slice.path));
    if (found < out.size()) return tooFewPixels(slice, out.size(), found);
    std::memcpy(out.data(), value->GetPointer(), out.size());
    const bool isBig = syntax.GetSwapCode() == gdcm::SwapCode::BigEndian;
    if (isBig == (nativeByteOrder() == ByteOrder::littleEndian)) swapBytes(out, slice.bitsAllocated / 8);
    if (slice.channels > 1 && number<0x0028, 0x0006>(set, 0) == 1) interleave(slice, out);
    return {};
}

Result<void> readCompressedPixels(const DicomSlice& slice, std::span<std::byte> out)
{
    gdcm::ImageReader reader;
    reader.SetFileName(slice.path.c_str());
    if (!reader.Read()) return Failure{slice.path + ": damaged: GDCM cannot read the compressed pixels"};
    const gdcm::Image& image = reader.GetImage();
    const unsigned* size = image.GetDimensions();
    const std::int64_t frames = image.GetNumberOfDimensions() > 2 ? size[2] : 1;
    if (size[0] != slice.columns || size[1] != slice.rows || frames != slice.frames ||
        image.GetBufferLength() != out.size())
        return tooFewPixels(slice, out.size(), image.GetBufferLength());
    if (!image.GetBuffer(reinterpret_cast<char*>(out.data())))
        return Failure{slice.path + ": damaged: GDCM cannot decompress the pixels"};
    if (slice.channels > 1 && image.GetPhotometricInterpretation() != gdcm::PhotometricInterpretation::RGB)
        return Failure{slice.path + ": expected colours that decompress to RGB, found \"" +
                       printable(image.GetPhotometricInterpretation().GetString()) + "\""};
    if (slice.channels > 1 && image.GetPlanarConfiguration() == 1) interleave(slice, out);
    return {};
}

// GDCM, as distributions build it, aborts where a file is not as it asserts. So it works in a process of its
// own, which sends values of the types below.

void send(const IsolatedProcess::Send& out, const std::string& text)
{
    const std::uint64_t length = text.size();
    out(std::as_bytes(std::span(&length, 1)));
    out(std::as_bytes(std::span(text)));
}

bool receive(IsolatedProcess& from, std::string& text)
{
    std::uint64_t length = 0;
    if (!from.receive(std::as_writable_bytes(std::span(&length, 1))) || length > 1 << 20) return false;
    text.resize(length);
    return from.receive(std::as_writable_bytes(std::span(text)));
}

enum class Answer : char { picture, nothing, failure };

/// The members of a slice but for its texts, which can be sent as they lie in memory.
struct SliceNumbers
{
    std::int64_t columns, rows, frames, instance;
    int channels, bitsAllocated, bitsStored, highBit;
    bool isSigned, lowIsWhite, isCompressed, hasDirections, hasPosition;
    std::array<Vector3, 2> directions;
    Vector3 position;
    std::array<double, 2> spacing;
    double sliceSpacing, slope, intercept;
};

void send(const IsolatedProcess::Send& out, const DicomSlice& slice)
{
    SliceNumbers numbers;
    std::memset(static_cast<void*>(&numbers), 0, sizeof numbers); // padding is sent, too
    numbers.columns = slice.columns;
    numbers.rows = slice.rows;
    numbers.frames = slice.frames;
    numbers.instance = slice.instance;
    numbers.channels = slice.channels;
    numbers.bitsAllocated = slice.bitsAllocated;
    numbers.bitsStored = slice.bitsStored;
    numbers.highBit = slice.highBit;
    numbers.isSigned = slice.isSigned;
    numbers.lowIsWhite = slice.lowIsWhite;
    numbers.isCompressed = slice.isCompressed;
    numbers.hasDirections = slice.directions.has_value();
    numbers.hasPosition = slice.position.has_value();
    numbers.directions = slice.directions.value_or(std::array<Vector3, 2>{});
    numbers.position = slice.position.value_or(Vector3{});
    numbers.spacing = slice.spacing;
    numbers.sliceSpacing = slice.sliceSpacing;
    numbers.slope = slice.slope;
    numbers.intercept = slice.intercept;
    out(std::as_bytes(std::span(&numbers, 1)));
    send(out, slice.series);
    send(out, slice.seriesDescription);
}

bool receive(IsolatedProcess& from, DicomSlice& slice)
{
    SliceNumbers numbers;
    if (!from.receive(std::as_writable_bytes(std::span(&numbers, 1)))) return false;
    slice.columns = numbers.columns;
    slice.rows = numbers.rows;
    slice.frames = numbers.frames;
    slice.instance = numbers.instance;
    slice.channels = numbers.channels;
    slice.bitsAllocated = numbers.bitsAllocated;
    slice.bitsStored = numbers.bitsStored;
    slice.highBit = numbers.highBit;
    slice.isSigned = numbers.isSigned;
    slice.lowIsWhite = numbers.lowIsWhite;
    slice.isCompressed = numbers.isCompressed;
    if (numbers.hasDirections) slice.directions = numbers.directions;
    if (numbers.hasPosition) slice.position = numbers.position;
    slice.spacing = numbers.spacing;
    slice.sliceSpacing = numbers.sliceSpacing;
    slice.slope = numbers.slope;
    slice.intercept = numbers.intercept;
    return receive(from, slice.series) && receive(from, slice.seriesDescription);
}

void send(const IsolatedProcess::Send& out, Answer answer)
{
    out(std::as_bytes(std::span(&answer, 1)));
}

bool receive(IsolatedProcess& from, Answer& answer)
{
    return from.receive(std::as_writable_bytes(std::span(&answer, 1)));
}

void sendHeader(const IsolatedProcess::Send& out, const std::string& path)
{
    const DicomHeader header = guarded(path, [&] { return headerOf(path); });
    send(out, !header ? Answer::failure : *header ? Answer::picture : Answer::nothing);
    if (!header) {
        send(out, header.failure().text);
    } else if (*header) {
        send(out, **header);
    }
}

/// None where the process ended instead.
std::optional<DicomHeader> receiveHeader(IsolatedProcess& from, const std::string& path)
{
    Answer answer{};
    if (!receive(from, answer)) return std::nullopt;
    if (answer == Answer::nothing) return DicomHeader(std::optional<DicomSlice>());
    if (answer == Answer::failure) {
        Failure failure;
        if (!receive(from, failure.text)) return std::nullopt;
        return DicomHeader(failure);
    }
    DicomSlice slice;
    slice.path = path;
    if (!receive(from, slice)) return std::nullopt;
    return DicomHeader(std::optional(slice));
}

/// Memory that reading one of these files may take: some copies of what it holds, and GDCM's own.
std::int64_t memoryFor(std::uintmax_t fileBytes, std::size_t pixelBytes)
{
    constexpr std::int64_t kLibrary = std::int64_t{512} << 20, kMost = std::int64_t{1} << 40;
    const auto file = static_cast<std::int64_t>(std::min<std::uintmax_t>(fileBytes, kMost));
    return kLibrary + 4 * file + 4 * static_cast<std::int64_t>(std::min<std::size_t>(pixelBytes, kMost));
}

Failure gaveUp(const std::string& path)
{
    return {path + ": expected a DICOM file, found a damaged one on which GDCM gives up"};
}

Result<void> pixelsOf(const DicomSlice& slice, std::span<std::byte> out)
{
    return guarded(slice.path, [&]() -> Result<void> {
        auto read = slice.isCompressed ? readCompressedPixels(slice, out) : readPlainPixels(slice, out);
        if (read) keepStoredBits(slice, out);
        return read;
    });
}

void sendPixels(const IsolatedProcess::Send& out, const DicomSlice& slice, std::span<std::byte> pixels)
{
    const auto read = pixelsOf(slice, pixels);
    send(out, read ? Answer::picture : Answer::failure);
    if (read) {
        out(pixels);
    } else {
        send(out, read.failure().text);
    }
}

} // namespace

std::vector<DicomHeader> readDicomHeaders(const std::vector<std::string>& paths)
{
    std::vector<DicomHeader> headers;
    std::uintmax_t largest = 0;
    for (const std::string& path : paths)
        largest = std::max(largest, bytesIn(path));
    while (headers.size() < paths.size()) {
        auto process = IsolatedProcess::start(memoryFor(largest, 0), [&](const IsolatedProcess::Send& out) {
            for (std::size_t i = headers.size(); i < paths.size(); ++i)
                sendHeader(out, paths[i]);
        });
        // Where the process ends early, the file that it was reading is the reason; a new one takes the rest.
        for (bool works = true; works && headers.size() < paths.size();) {
            const std::string& path = paths[headers.size()];
            auto header = process ? receiveHeader(*process, path) : std::nullopt;
            works = header.has_value();
            if (works) {
                headers.push_back(*header);
            } else {
                headers.push_back(process ? gaveUp(path) : Failure{path + ": " + process.failure().text});
            }
        }
    }
    return headers;
}

Result<void> readDicomPixels(const std::vector<DicomSlice>& slices, std::span<std::byte> out)
{
    const std::size_t each = out.size() / slices.size();
    std::uintmax_t largest = 0;
    for (const DicomSlice& slice : slices)
        largest = std::max(largest, bytesIn(slice.path));
    auto process = IsolatedProcess::start(memoryFor(largest, each), [&](const IsolatedProcess::Send& answer) {
        for (const DicomSlice& slice : slices)
            sendPixels(answer, slice, out.first(each));
    });
    if (!process) return Failure{slices.front().path + ": " + process.failure().text};
    for (const DicomSlice& slice : slices) {
        Answer answer{};
        if (!receive(*process, answer)) return gaveUp(slice.path);
        if (answer != Answer::picture) {
            Failure failure;
            return receive(*process, failure.text) ? failure : gaveUp(slice.path);
        }
        if (!process->receive(out.first(each))) return gaveUp(slice.path);
        out = out.subspan(each);
    }
    return {};
}

} // namespace vo

extern "C" const vo::DicomFunctions volumizerDicom;
extern "C" __attribute__((visibility("default")))
const vo::DicomFunctions volumizerDicom = {vo::readDicomHeaders, vo::readDicomPixels};
