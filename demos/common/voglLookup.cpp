#include "voglMain.h"
#include "voglLookup.h"

#include "lookup_file.h"
#include "lookup_ramp.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

namespace {

constexpr int kEntries = 256;

std::optional<vo::LookupFile> file;
std::vector<float> entries;
voLookupTable* table;
vo::RampSettings ramp;
double dataLow, dataHigh;
int components;

/// The file's entries in as many components as the table has.
std::vector<float> fileEntries()
{
    std::vector<float> result;
    for (int i = 0; i < kEntries; ++i) {
        const float* rgba = &file->rgba[std::size_t(4 * i)];
        if (components == 4) {
            result.insert(result.end(), rgba, rgba + 4);
        } else {
            result.insert(result.end(), {0.30f * rgba[0] + 0.59f * rgba[1] + 0.11f * rgba[2], rgba[3]});
        }
    }
    return result;
}

double longestSide(voBrickSet* brickSet)
{
    int x, y, z;
    brickSet->getVolumeSizes(x, y, z);
    return std::max({x * modelScale[0], y * modelScale[1], z * modelScale[2]});
}

bool hasOneChannel(voBrickSet* brickSet)
{
    const voExternalFormatType format = brickSet->getBrick(0)->getExternalFormat();
    return format == voExternalFormatTypeScope::LUMINANCE || format == voExternalFormatTypeScope::INTENSITY;
}

/// The ramp's present entries, in the storage that the table reads.
void loadRamp()
{
    const auto values = vo::rampEntries(ramp, dataLow, dataHigh, kEntries, components);
    std::copy(values.begin(), values.end(), entries.begin());
    table->load();
}

} // namespace

voRenderingMode readLookupTable(const char* program)
{
    if (!options.lutFile.empty()) {
        auto read = vo::readLookupFile(options.lutFile);
        if (!read) {
            std::fprintf(stderr, "%s: %s\n", program, read.failure().text.c_str());
            std::exit(1);
        }
        file = *read;
    }
    const bool color = options.color.value_or(file && file->isColor);
    return color ? voRenderingModeScope::COLOR : voRenderingModeScope::MONOCHROME;
}

void initLookupTable(voBrickSetCollection* aVolume, voRenderingMode renderingMode, double low, double high)
{
    voBrickSet* brickSet = aVolume->getCurrentBrickSet();
    if (!file && !options.lut && !hasOneChannel(brickSet)) return;
    voLookupTableType lookupType = voLookupTableTypeScope::POST_INTERPOLATION;
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    voDataType dataType;
    voLookupTable::getBestParameters(aVolume, renderingMode, kEntries, lookupType, internalFormat,
                                     externalFormat, dataType);
    components = externalFormat == voExternalFormatTypeScope::LUMINANCE_ALPHA ? 2 : 4;
    dataLow = low;
    dataHigh = high;
    entries.resize(std::size_t(kEntries * components));
    if (lookupType == voLookupTableTypeScope::PRE_INTERPOLATION) {
        table = new voLookupTablePre(internalFormat, kEntries, externalFormat, dataType, entries.data());
    } else {
        table = new voLookupTablePost(internalFormat, kEntries, externalFormat, dataType, entries.data());
    }
    if (file) {
        const auto values = fileEntries();
        std::copy(values.begin(), values.end(), entries.begin());
        table->load();
    } else {
        const auto wanted = options.lut.value_or(vo::Options::Ramp{(low + high) / 2, high - low});
        ramp = {wanted.center, wanted.width, vo::sliceOpacity(options.sampling, longestSide(brickSet))};
        loadRamp();
    }
    table->enable();
}

void moveLookupRamp(double center, double width)
{
    if (!table || file) return;
    const double range = dataHigh - dataLow;
    ramp.center = dataLow + center * range;
    ramp.width = std::max(width, 1.0 / kEntries) * range;
    loadRamp();
}

void deleteLookupTable()
{
    delete table;
    table = nullptr;
}
