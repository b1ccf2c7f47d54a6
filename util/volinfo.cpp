// volinfo FILE...: what a volume file holds.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "utility.h"
#include "volume_statistics.h"

namespace {

constexpr const char* kHelp =
    R"(volinfo [-json] FILE...

Prints for each volume its format, sizes, type, spacing, orientation, range,
mean and histogram. FILE is a file that the other programs read (TIFF, NRRD,
NIfTI, MetaImage, DICOM, PNG, JPEG) or a folder with a DICOM series. Values that are
not numbers are counted apart; ranges and means are those of the finite ones.
In the histogram the length of a bar goes by the square root of the count.

  -json      print an array with an object for each file
  -help      print this text
  -version   print the version

Example:
    volinfo head.nii.gz series/
)";

constexpr std::size_t kBins = 20;
constexpr double kLongestBar = 40;
constexpr const char* kChannelNames[4][4] = {
    {"value"}, {"luminance", "alpha"}, {}, {"red", "green", "blue", "alpha"}};

struct VolumeReport
{
    std::string path;
    vo::VolumeInfo info;
    vo::VolumeDescription about;
    std::vector<vo::ChannelStatistics> channels;
};

vo::Result<VolumeReport> reportOn(const std::string& path)
{
    auto volume = vo::openVolume(path);
    if (!volume) return volume.failure();
    auto channels = vo::statisticsOf("volinfo", path, *volume, kBins);
    if (!channels) return channels.failure();
    return VolumeReport{path, volume->info(), volume->description(), std::move(*channels)};
}

/// The shortest text that tells a number from its neighbours among floats.
std::string text(double value)
{
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.7g", value);
    return digits;
}

const char* channelName(const VolumeReport& report, std::size_t channel)
{
    return kChannelNames[report.info.channels - 1][channel];
}

std::string orientationText(const vo::PatientFrame& orientation)
{
    if (!orientation.known) return "unknown; in the order of the file";
    return orientation.fileAxes + " in the file; arrives with x right, y front, z up" +
           (orientation.obliqueDegrees > 0.005
                ? ", turned by " + text(std::round(orientation.obliqueDegrees * 100) / 100) + " degrees"
                : "");
}

void printHistogram(const VolumeReport& report, const vo::ChannelStatistics& channel)
{
    const std::size_t parts = channel.histogram.size();
    const double range = channel.high - channel.low;
    const bool isEach = report.info.type != vo::ChannelType::float32 && range + 1 == double(parts);
    const double width = isEach ? 1 : range / double(parts);
    const auto most = double(std::ranges::max(channel.histogram));
    for (std::size_t i = 0; i < parts; ++i) {
        const auto count = channel.histogram[i];
        const auto bar = static_cast<std::size_t>(std::ceil(kLongestBar * std::sqrt(double(count) / most)));
        std::printf("    %12s  %12lld %s\n", text(channel.low + double(i) * width).c_str(),
                    static_cast<long long>(count), std::string(bar, '#').c_str());
    }
}

void printChannel(const VolumeReport& report, std::size_t number)
{
    const vo::ChannelStatistics& channel = report.channels[number];
    const bool isScaled = report.about.slope != 1 || report.about.intercept != 0;
    const auto scaled = [&](double value) {
        return text(report.about.slope * value + report.about.intercept);
    };
    std::printf("  %s\n", channelName(report, number));
    if (channel.notANumber)
        std::printf("    not a number  %lld\n", static_cast<long long>(channel.notANumber));
    if (channel.infinite) std::printf("    infinite      %lld\n", static_cast<long long>(channel.infinite));
    if (channel.low > channel.high) return;
    std::printf("    range         %s to %s%s\n", text(channel.low).c_str(), text(channel.high).c_str(),
                isScaled ? (", scaled " + scaled(channel.low) + " to " + scaled(channel.high)).c_str() : "");
    std::printf("    mean          %s%s\n", text(channel.mean).c_str(),
                isScaled ? (", scaled " + scaled(channel.mean)).c_str() : "");
    printHistogram(report, channel);
}

void printText(const VolumeReport& report)
{
    const auto& [size, channels, type] = report.info;
    const auto& spacing = report.about.spacing;
    std::printf("%s\n", report.path.c_str());
    std::printf("  format          %s\n", report.about.format.c_str());
    std::printf("  size            %lld x %lld x %lld voxels\n", static_cast<long long>(size[0]),
                static_cast<long long>(size[1]), static_cast<long long>(size[2]));
    std::printf("  type            %s, %d channel%s%s\n", vo::channelTypeName(type), channels,
                channels == 1 ? "" : "s", report.about.alphaAdded ? ", alpha not in the file" : "");
    if (report.about.spacingKnown)
        std::printf("  spacing         %s x %s x %s mm\n", text(spacing[0]).c_str(), text(spacing[1]).c_str(),
                    text(spacing[2]).c_str());
    else
        std::printf("  spacing         unknown\n");
    std::printf("  orientation     %s\n", orientationText(report.about.orientation).c_str());
    if (report.about.slope != 1 || report.about.intercept != 0)
        std::printf("  scale           value * %s + %s\n", text(report.about.slope).c_str(),
                    text(report.about.intercept).c_str());
    for (const std::string& note : report.about.notes)
        std::printf("  note            %s\n", note.c_str());
    for (std::size_t i = 0; i < report.channels.size(); ++i)
        printChannel(report, i);
}

std::string quoted(const std::string& words)
{
    std::string out = "\"";
    for (const char letter : words) {
        char code[8];
        std::snprintf(code, sizeof code, "\\u%04x", unsigned(static_cast<unsigned char>(letter)));
        if (letter == '"' || letter == '\\')
            (out += '\\') += letter;
        else if (static_cast<unsigned char>(letter) < ' ')
            out += code;
        else
            out += letter;
    }
    return out + '"';
}

/// A list in brackets of what `write` makes of each value.
template <class Values, class Write>
std::string listed(const Values& values, const Write& write)
{
    std::string out = "[";
    for (const auto& value : values)
        out.append(out.size() > 1 ? ", " : "").append(write(value));
    return out + "]";
}

/// A number that JSON has: as exact as a double.
std::string exact(double value)
{
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    return std::isfinite(value) ? digits : "null";
}

std::string json(const vo::ChannelStatistics& channel)
{
    const bool isEmpty = channel.low > channel.high;
    return "{\"low\": " + (isEmpty ? "null" : exact(channel.low)) +
           ", \"high\": " + (isEmpty ? "null" : exact(channel.high)) +
           ", \"mean\": " + (isEmpty ? "null" : exact(channel.mean)) +
           ", \"notANumber\": " + std::to_string(channel.notANumber) +
           ", \"infinite\": " + std::to_string(channel.infinite) + ", \"histogram\": " +
           listed(channel.histogram, [](std::int64_t count) { return std::to_string(count); }) + "}";
}

std::string json(const VolumeReport& report)
{
    const vo::VolumeDescription& about = report.about;
    const auto whole = [](std::int64_t value) { return std::to_string(value); };
    const auto vector = [](const std::array<double, 3>& v) { return listed(v, exact); };
    return "  {\"file\": " + quoted(report.path) + ", \"format\": " + quoted(about.format) +
           ",\n   \"size\": " + listed(report.info.size, whole) +
           ", \"channels\": " + std::to_string(report.info.channels) +
           ", \"type\": " + quoted(vo::channelTypeName(report.info.type)) +
           ", \"alphaAdded\": " + (about.alphaAdded ? "true" : "false") +
           ",\n   \"spacing\": " + (about.spacingKnown ? vector(about.spacing) : "null") +
           ", \"fileAxes\": " + (about.orientation.known ? quoted(about.orientation.fileAxes) : "null") +
           ",\n   \"direction\": " + listed(about.orientation.direction, vector) +
           ", \"obliqueDegrees\": " + exact(about.orientation.obliqueDegrees) +
           ",\n   \"slope\": " + exact(about.slope) + ", \"intercept\": " + exact(about.intercept) +
           ", \"notes\": " + listed(about.notes, quoted) + ",\n   \"values\": " +
           listed(report.channels, [](const vo::ChannelStatistics& channel) { return json(channel); }) + "}";
}

vo::Result<void> run(const std::vector<std::string>& arguments)
{
    std::vector<std::string> paths;
    bool asJson = false;
    for (const std::string& word : arguments) {
        if (word == "-json")
            asJson = true;
        else if (word.starts_with('-') && word.size() > 1)
            return vo::Failure{"expected -json or a file name, found the option \"" + word + "\""};
        else
            paths.push_back(word);
    }
    if (paths.empty()) return vo::Failure{"expected files, found none; volinfo -help shows an example"};

    // The files that can be read are described whatever the others are.
    vo::Result<void> result;
    std::string objects;
    for (const std::string& path : paths) {
        const auto report = reportOn(path);
        if (!report) {
            if (!result) vo::warn("volinfo", result.failure().text);
            result = report.failure();
            if (vo::interrupted()) break;
        } else if (asJson) {
            objects.append(objects.empty() ? "" : ",\n").append(json(*report));
        } else {
            printText(*report);
        }
    }
    if (asJson) std::printf("[\n%s\n]\n", objects.c_str());
    return result;
}

} // namespace

int main(int argc, char** argv)
{
    return vo::runUtility({"volinfo", kHelp, run}, argc, argv);
}
