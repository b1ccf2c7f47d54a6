#include "volume_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>

#include "dicom_slice.h"
#include "input_file.h"
#include "printable_text.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

// Slices whose places differ by less than this part of their distance lie in the same place, and gaps that
// differ by more are worth a note.
constexpr double kSamePlace = 0.01;
constexpr double kUnequalGaps = 0.001;

using Slices = std::vector<DicomSlice>;

Vector3 cross(const Vector3& a, const Vector3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector3& a, const Vector3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::string shortText(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// What slices of one volume have in common, as text to compare and to sort by.
std::string groupOf(const DicomSlice& slice)
{
    std::string group = slice.series + "|" + std::to_string(slice.columns) + " x " +
                        std::to_string(slice.rows) + "|" + std::to_string(slice.channels) + " " +
                        std::to_string(slice.bitsAllocated) + (slice.isSigned ? "s" : "u") +
                        (slice.directions ? "" : "|nowhere");
    if (slice.directions)
        for (const Vector3& direction : *slice.directions)
            for (const double part : direction)
                group += " " + std::to_string(std::lround(std::clamp(part, -2.0, 2.0) * 1000));
    return group;
}

/// The pictures of a folder, those of each volume together.
Result<std::map<std::string, Slices>> slicesIn(const std::string& folder, VolumeDescription& about)
{
    std::error_code error;
    std::vector<std::string> paths;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code unknown;
        if (entry->is_regular_file(unknown)) paths.push_back(entry->path().string());
    }
    if (error) return Failure{folder + ": cannot read the folder: " + error.message()};
    std::ranges::sort(paths);
    std::map<std::string, Slices> groups;
    std::size_t others = 0;
    std::string damaged;
    for (const DicomHeader& slice : readDicomHeaders(paths)) {
        if (!slice && damaged.empty()) damaged = slice.failure().text;
        if (!slice || !*slice) {
            ++others;
        } else {
            groups[groupOf(**slice)].push_back(**slice);
        }
    }
    if (groups.empty())
        return Failure{damaged.empty() ? folder + ": expected a folder with DICOM pictures, found none in " +
                                             std::to_string(paths.size()) + " files"
                                       : damaged};
    if (others > 0)
        about.notes.push_back(std::to_string(others) + (others == 1 ? " file is" : " files are") +
                              " no DICOM picture that can be read" +
                              (damaged.empty() ? "" : " (" + damaged + ")"));
    return groups;
}

std::string nameOf(const Slices& slices)
{
    const DicomSlice& first = slices.front();
    const std::string name = first.seriesDescription.empty() ? first.series : first.seriesDescription;
    return "\"" + printable(name) + "\" with " + std::to_string(slices.size()) +
           (slices.size() == 1 ? " file of " : " files of ") + std::to_string(first.columns) + " x " +
           std::to_string(first.rows);
}

/// The largest group; a note names the others.
Slices largest(std::map<std::string, Slices> groups, VolumeDescription& about)
{
    const auto size = [](const auto& group) { return group.second.size(); };
    const auto chosen = std::ranges::max_element(groups, {}, size);
    Slices slices = std::move(chosen->second);
    groups.erase(chosen);
    std::string others;
    for (const auto& [key, group] : groups)
        others += (others.empty() ? "" : ", ") + nameOf(group);
    if (!others.empty()) about.notes.push_back("read " + nameOf(slices) + "; left out " + others);
    return slices;
}

/// Sorts by place along the normal, or, where there are no places, by number. Of several slices in one place
/// the first by number stays. The step from slice to slice, in mm left, back, up, if it is known.
std::optional<Vector3> sortSlices(Slices& slices, VolumeDescription& about)
{
    std::ranges::stable_sort(slices, {}, &DicomSlice::instance);
    const bool placed = std::ranges::all_of(slices, [](const DicomSlice& slice) {
        return slice.directions && slice.position && std::isfinite(dot(*slice.position, *slice.position));
    });
    if (!placed) {
        about.notes.emplace_back("the slices do not say where they lie and are sorted by their number");
        return std::nullopt;
    }
    const Vector3 normal = cross((*slices[0].directions)[0], (*slices[0].directions)[1]);
    const auto height = [&normal](const DicomSlice& slice) { return dot(*slice.position, normal); };
    std::ranges::stable_sort(slices, {}, height);
    const double range = height(slices.back()) - height(slices.front());
    const double tooClose = kSamePlace * range / double(slices.size());
    const auto before = slices.size();
    const auto inOnePlace = [&](const DicomSlice& a, const DicomSlice& b) {
        return height(b) - height(a) <= tooClose;
    };
    slices.erase(std::unique(slices.begin(), slices.end(), inOnePlace), slices.end());
    if (slices.size() < before)
        about.notes.push_back("left out " + std::to_string(before - slices.size()) +
                              " slices in the place of others");
    if (slices.size() < 2) {
        const double step = slices[0].sliceSpacing > 0 ? slices[0].sliceSpacing : 1;
        return Vector3{normal[0] * step, normal[1] * step, normal[2] * step};
    }
    double least = range, most = 0;
    for (std::size_t i = 1; i < slices.size(); ++i) {
        const double gap = height(slices[i]) - height(slices[i - 1]);
        least = std::min(least, gap);
        most = std::max(most, gap);
    }
    if (most - least > kUnequalGaps * most)
        about.notes.push_back("slices lie " + shortText(least) + " to " + shortText(most) +
                              " mm apart and are taken as equally far");
    const double step = range / double(slices.size() - 1);
    return Vector3{normal[0] * step, normal[1] * step, normal[2] * step};
}

Placement placementOf(const DicomSlice& slice, const std::optional<Vector3>& sliceStep)
{
    const Placement unturned = fileOrder(
        {slice.spacing[0], slice.spacing[1], slice.sliceSpacing > 0 ? slice.sliceSpacing : slice.spacing[0]});
    if (!slice.directions || !sliceStep) return unturned;
    std::array<Vector3, 3> steps{(*slice.directions)[0], (*slice.directions)[1], *sliceStep};
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (double& part : steps[axis])
            part *= slice.spacing[axis] > 0 ? slice.spacing[axis] : 1;
    for (Vector3& step : steps)
        step = fromLeftBackUp(step);
    return placementOfSteps(steps).value_or(unturned);
}

/// Of one file, whose frames follow each other along the normal.
Placement placementOfFile(const DicomSlice& slice)
{
    if (!slice.directions) return placementOf(slice, std::nullopt);
    Vector3 step = cross((*slice.directions)[0], (*slice.directions)[1]);
    for (double& part : step)
        part *= slice.sliceSpacing > 0 ? slice.sliceSpacing : 1;
    return placementOf(slice, step);
}

/// Where slices have scales of their own, so that a voxel means nothing without: applies them.
Result<void> applyScales(const std::string& path, const Slices& slices, StoredLayout& layout,
                         MemoryBlock& block)
{
    StoredLayout floats = layout;
    floats.type = StoredType::float32;
    const auto bytes = storedBytes(path, floats);
    if (!bytes) return bytes.failure();
    auto scaled = MemoryBlock::allocate(path, *bytes);
    if (!scaled) return scaled.failure();
    // Served once without turning, as floats, then scaled in place.
    const std::int64_t perSlice = *bytes / static_cast<std::int64_t>(slices.size());
    const auto step = static_cast<std::size_t>(bytesPerNumber(layout.type));
    const std::byte* from = block.bytes().data();
    for (std::size_t i = 0; i < slices.size(); ++i) {
        std::byte* to = scaled->bytes().data() + std::int64_t(i) * perSlice;
        for (std::int64_t k = 0; k < perSlice; k += 4, from += step, to += 4) {
            const double value = slices[i].slope * numberAt(layout.type, from) + slices[i].intercept;
            const auto number = static_cast<float>(value);
            std::memcpy(to, &number, sizeof number);
        }
    }
    layout = floats;
    block = std::move(*scaled);
    return {};
}

bool sameScale(const Slices& slices)
{
    return std::ranges::all_of(slices, [&](const DicomSlice& slice) {
        return slice.slope == slices[0].slope && slice.intercept == slices[0].intercept;
    });
}

Result<VolumeFile> openSlices(const std::string& path, const Slices& slices, const Placement& placement,
                              VolumeDescription about)
{
    StoredLayout layout = slices[0].layout();
    if (slices.size() > 1) layout.size[2] = static_cast<std::int64_t>(slices.size());
    const auto bytes = storedBytes(path, layout);
    if (!bytes) return bytes.failure();
    const std::int64_t perFile = *bytes / static_cast<std::int64_t>(slices.size());
    for (const DicomSlice& slice : slices) {
        const auto file = InputFile::open(slice.path);
        if (!file) return file.failure();
        // JPEG and its like shrink a picture of one colour by some thousands.
        const std::int64_t mostPerByte = slice.isCompressed ? 16384 : 1;
        if (perFile / mostPerByte > file->size())
            return Failure{slice.path + ": cut off or damaged: expected " + std::to_string(perFile) +
                           " bytes of pixels, found a file of " + std::to_string(file->size()) + " bytes"};
    }
    auto block = MemoryBlock::allocate(path, *bytes);
    if (!block) return block.failure();
    if (auto read = readDicomPixels(slices, block->bytes()); !read) return read.failure();
    if (sameScale(slices)) {
        about.slope = slices[0].slope;
        about.intercept = slices[0].intercept;
    } else {
        if (auto applied = applyScales(path, slices, layout, *block); !applied) return applied.failure();
        about.notes.emplace_back("slices have scales of their own, which are applied: values are float32");
    }
    if (slices[0].lowIsWhite) about.notes.emplace_back("low values stand for white (MONOCHROME1)");
    about.format = "DICOM";
    return openStoredVoxels(layout, placement, bytesInMemory(std::move(*block)), std::move(about));
}

} // namespace

Result<VolumeFile> openDicomFile(const std::string& path)
{
    const DicomHeader slice = readDicomHeaders({path}).front();
    if (!slice) return slice.failure();
    if (!*slice) return Failure{path + ": expected a DICOM file with a picture, found none"};
    return openSlices(path, {**slice}, placementOfFile(**slice), VolumeDescription());
}

Result<VolumeFile> openDicomFolder(const std::string& path)
{
    VolumeDescription about;
    auto groups = slicesIn(path, about);
    if (!groups) return groups.failure();
    Slices slices = largest(std::move(*groups), about);
    // A file of many frames is a volume of its own.
    const bool hasFrames = std::ranges::any_of(slices, [](const DicomSlice& s) { return s.frames > 1; });
    if (slices.size() > 1 && hasFrames)
        return Failure{path + ": expected slices of one frame, found " + std::to_string(slices.size()) +
                       " files of several; open one of them"};
    if (hasFrames) return openSlices(path, slices, placementOfFile(slices[0]), std::move(about));
    const auto step = sortSlices(slices, about);
    const Placement placement = placementOf(slices[0], step);
    return openSlices(path, slices, placement, std::move(about));
}

} // namespace vo
