#include "ramp_brick.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

// A 3D texture may be at least 256 voxels long, and has 2048 on most machines. Hardware that divides the way
// between voxels by 256 tells 16 x 256 values apart where it has 16 steps.
constexpr int kMostSteps = 255, kMostVoxels = 1024;

} // namespace

// Beyond the table's range the row goes on at its ends' values: the bends are then at voxels, where linear
// interpolation has them exactly.
RampBrick::RampBrick(double tableLow, double tableHigh, double low, double high)
    : tableLow_(tableLow), tableHigh_(tableHigh > tableLow ? tableHigh : tableLow + 1)
{
    const double width = tableHigh_ - tableLow_;
    const double below = std::max(tableLow_ - low, 0.0) / width,
                 above = std::max(high - tableHigh_, 0.0) / width;
    steps_ =
        std::clamp(int((kMostVoxels - 3) / std::min(1 + below + above, 1.0 * kMostVoxels)), 1, kMostSteps);
    const double room = kMostVoxels - 1 - steps_;
    below_ = int(std::ceil(std::min(below * steps_, room / 2)));
    above_ = int(std::ceil(std::min(above * steps_, room - below_)));
}

float RampBrick::placeOf(double value) const
{
    const double place = below_ + steps_ * ((value - tableLow_) / (tableHigh_ - tableLow_));
    return float(0.5 + std::clamp(place, 0.0, double(below_ + steps_ + above_)));
}

VoglVolume RampBrick::makeVolume(voRenderingMode renderingMode) const
{
    VoglVolume volume;
    volume.renderingMode = renderingMode;
    volume.size[0] = below_ + steps_ + above_ + 1;
    volume.loValue = float(tableLow_);
    volume.hiValue = float(tableHigh_);
    volume.maxBrickCount = 1;
    const voExternalFormatType given = voExternalFormatTypeScope::LUMINANCE;
    voExternalFormatType externalFormat;
    voInternalFormatType internalFormat;
    int size[3] = {volume.size[0], 1, 1};
    voAppearanceActions::getBestParameters(voInterpolationTypeScope::_3D, renderingMode,
                                           voDataTypeScope::UNSIGNED_SHORT, given, internalFormat,
                                           externalFormat, size[0], size[1], size[2]);
    volume.bricks = new voBrickSetCollection(
        volume.size[0], 1, 1, size[0], size[1], size[2], voPartialBrickTypeScope::AUGMENT, 0, internalFormat,
        externalFormat, voDataTypeScope::UNSIGNED_SHORT, voInterpolationTypeScope::_3D);
    volume.bricks->setCurrentBrickSet(voPlaneOrientationScope::XY);
    voBrick* brick = volume.bricks->getCurrentBrickSet()->getBrick(0);
    unsigned short* voxels = static_cast<unsigned short*>(voAppearanceActions::dataAlloc(brick));
    if (!voxels) exit(1);
    std::fill_n(voxels, std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]), 65535);
    for (int i = 0; i < volume.size[0]; i++) {
        const double part = std::clamp(double(i - below_) / steps_, 0.0, 1.0);
        voxels[i] = static_cast<unsigned short>(std::lround(65535 * part));
    }
    voAppearanceActions::dataConvert(brick, voxels, given);
    return volume;
}
