// iflto3Dtiff in1 in2 ... out: slices, or a volume of any format, become a TIFF volume (guide, page 148).

#include <optional>

#include "copy_slices.h"
#include "utility.h"

namespace {

constexpr const char* kHelp =
    R"(iflto3Dtiff [-compress] in1 [in2 ...] out

Puts images together to a volume: a TIFF file with one page for each slice, the
slices in the order of the arguments. Each input is a file of one or more
slices (TIFF, PNG, NRRD, NIfTI, MetaImage, DICOM) or a folder with a DICOM
series; all have the same width, height, channels and type. One input alone is
converted. Volumes that say how they lie in the patient are written with x to
the right, y to the front and z up.

  -compress   compress the pages (deflate)
  -help       print this text
  -version    print the version

Examples: three slices; a DICOM series
    iflto3Dtiff slice1.tif slice2.tif slice3.tif head.tif
    iflto3Dtiff series/ head.tif
)";

struct Request
{
    std::vector<std::string> inputs;
    std::string output;
    vo::TiffOptions options;
};

vo::Result<Request> parsedRequest(const std::vector<std::string>& arguments)
{
    Request request;
    for (const std::string& word : arguments) {
        if (word == "-compress") {
            request.options.compression = vo::Compression::deflate;
        } else if (word.starts_with('-') && word.size() > 1) {
            return vo::Failure{"expected -compress or a file name, found the option \"" + word + "\""};
        } else {
            request.inputs.push_back(word);
        }
    }
    if (request.inputs.size() < 2)
        return vo::Failure{"expected in1 [in2 ...] out, found " + std::to_string(request.inputs.size()) +
                           " file names; iflto3Dtiff -help shows an example"};
    request.output = request.inputs.back();
    request.inputs.pop_back();
    return request;
}

std::string text(const vo::VolumeInfo& info)
{
    return std::to_string(info.size[0]) + " x " + std::to_string(info.size[1]) + " with " +
           std::to_string(info.channels) + " channels of " + vo::channelTypeName(info.type);
}

/// All inputs together; those that differ from the first are a failure.
vo::Result<vo::VolumeInfo> stackedInfo(const std::vector<std::string>& inputs,
                                       std::optional<vo::VolumeFile>& only)
{
    vo::VolumeInfo all;
    for (const std::string& path : inputs) {
        auto volume = vo::openVolume(path);
        if (!volume) return volume.failure();
        for (const std::string& note : volume->description().notes)
            vo::warn("iflto3Dtiff", path + ": " + note);
        vo::VolumeInfo info = volume->info();
        if (&path == &inputs.front()) {
            all = info;
            all.size[2] = 0;
        }
        const std::int64_t slices = info.size[2];
        info.size[2] = all.size[2];
        if (info != all)
            return vo::Failure{path + ": expected slices like those of " + inputs.front() + " (" + text(all) +
                               "), found " + text(info)};
        all.size[2] += slices;
        if (inputs.size() == 1) only.emplace(std::move(*volume));
    }
    return all;
}

vo::Result<void> writeStack(const Request& request)
{
    if (auto fit = vo::checkOutput(request.output, request.inputs); !fit) return fit;
    std::optional<vo::VolumeFile> only; // kept open where there is one: it may have been decoded whole
    const auto info = stackedInfo(request.inputs, only);
    if (!info) return info.failure();
    auto writer = vo::TiffStackWriter::create(request.output, *info, request.options);
    if (!writer) return writer.failure();
    std::int64_t done = 0;
    for (const std::string& path : request.inputs) {
        auto volume = only ? vo::Result<vo::VolumeFile>(std::move(*only)) : vo::openVolume(path);
        if (!volume) return volume.failure();
        auto copied = vo::copySlices("iflto3Dtiff", request.output, *volume, *writer, done, info->size[2]);
        if (!copied) return copied;
        done += volume->info().size[2];
    }
    return writer->finish();
}

vo::Result<void> run(const std::vector<std::string>& arguments)
{
    const auto request = parsedRequest(arguments);
    return request ? writeStack(*request) : request.failure();
}

} // namespace

int main(int argc, char** argv)
{
    return vo::runUtility({"iflto3Dtiff", kHelp, run}, argc, argv);
}
