#include "voglLookup.h"
#include "voglMain.h"

#include "volume_view/defaults.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr int kEntries = 256;

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

} // namespace

/// The ramp's present entries, in the storage that the table reads.
void VoglLookup::loadRamp()
{
    const auto values = vo::rampEntries(ramp_, dataLow_, dataHigh_, kEntries, components_);
    std::copy(values.begin(), values.end(), entries_.begin());
    for (std::size_t i = 0; components_ == 4 && i < entries_.size(); ++i)
        if (i % 4 < 3) entries_[i] *= tint_[i % 4];
    table_->load();
}

void VoglLookup::read(const char* program, const std::string& fileName, std::optional<vo::Options::Ramp> lut)
{
    lut_ = lut;
    if (fileName.empty()) return;
    auto read = vo::readLookupFile(fileName);
    if (!read) {
        std::fprintf(stderr, "%s: %s\n", program, read.failure().text.c_str());
        std::exit(1);
    }
    file_ = *read;
}

void VoglLookup::tintFile(float red, float green, float blue)
{
    if (!file_) return;
    file_->isColor = true;
    for (std::size_t entry = 0; entry < file_->rgba.size(); entry += 4) {
        file_->rgba[entry] *= red;
        file_->rgba[entry + 1] *= green;
        file_->rgba[entry + 2] *= blue;
    }
}

voRenderingMode VoglLookup::renderingMode() const
{
    const bool coloured = file_ ? file_->isColor : tint_[0] != tint_[1] || tint_[1] != tint_[2];
    return vo::inColor(options, coloured) ? voRenderingModeScope::COLOR : voRenderingModeScope::MONOCHROME;
}

void VoglLookup::make(voBrickSetCollection* aVolume, voRenderingMode renderingMode, double low, double high)
{
    voBrickSet* brickSet = aVolume->getCurrentBrickSet();
    if (!file_ && !lut_ && !hasOneChannel(brickSet)) return;
    voLookupTableType lookupType = voLookupTableTypeScope::POST_INTERPOLATION;
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    voDataType dataType;
    voLookupTable::getBestParameters(aVolume, renderingMode, kEntries, lookupType, internalFormat,
                                     externalFormat, dataType);
    components_ = externalFormat == voExternalFormatTypeScope::LUMINANCE_ALPHA ? 2 : 4;
    dataLow_ = low;
    dataHigh_ = high;
    entries_.resize(std::size_t(kEntries * components_));
    if (lookupType == voLookupTableTypeScope::PRE_INTERPOLATION) {
        table_ = new voLookupTablePre(internalFormat, kEntries, externalFormat, dataType, entries_.data());
    } else {
        table_ = new voLookupTablePost(internalFormat, kEntries, externalFormat, dataType, entries_.data());
    }
    if (file_) {
        const auto values = vo::tableEntries(*file_, components_);
        std::copy(values.begin(), values.end(), entries_.begin());
        table_->load();
    } else {
        const auto wanted = lut_.value_or(vo::Options::Ramp{(low + high) / 2, high - low});
        const double opacity =
            rampOpacity_ ? *rampOpacity_ : vo::sliceOpacity(options.sampling, longestSide(brickSet));
        ramp_ = {wanted.center, wanted.width, opacity};
        loadRamp();
    }
    table_->enable();
}

void VoglLookup::enable()
{
    if (table_)
        table_->enable();
    else
        disable();
}

void VoglLookup::disable()
{
    // Any table switches its kind off.
    voLookupTablePost(voInternalFormatTypeScope::RGBA8_EXT, 2, voExternalFormatTypeScope::RGBA,
                      voDataTypeScope::FLOAT)
        .disable();
}

void VoglLookup::moveRamp(double center, double width)
{
    if (!table_ || file_) return;
    const double range = dataHigh_ - dataLow_;
    ramp_.center = dataLow_ + center * range;
    ramp_.width = std::max(width, 1.0 / kEntries) * range;
    loadRamp();
}

std::vector<float> VoglLookup::rgbaEntries() const
{
    if (components_ == 4) return entries_;
    std::vector<float> rgba;
    for (std::size_t i = 0; i + 1 < entries_.size(); i += 2)
        rgba.insert(rgba.end(), {entries_[i], entries_[i], entries_[i], entries_[i + 1]});
    return rgba;
}

void VoglLookup::free()
{
    delete table_;
    table_ = nullptr;
}

VoglLookup& voglLookup()
{
    static VoglLookup lookup;
    return lookup;
}

voRenderingMode readLookupTable(const char* program)
{
    voglLookup().read(program, options.lutFile, options.lut);
    return voglLookup().renderingMode();
}

void initLookupTable(voBrickSetCollection* aVolume, voRenderingMode renderingMode, double low, double high)
{
    voglLookup().make(aVolume, renderingMode, low, high);
}

void moveLookupRamp(double center, double width)
{
    voglLookup().moveRamp(center, width);
}

void deleteLookupTable()
{
    voglLookup().free();
}
