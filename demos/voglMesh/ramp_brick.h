#pragma once

#include "voglVolume.h"

/** The values of a field as voxels: a row that rises steadily. A vertex whose voxel coordinate is the place
   of its value makes textures interpolate the field itself, linearly inside a tetrahedron; what the table
   makes of it comes after. */
class RampBrick
{
public:
    /** The table spans tableLow to tableHigh, the field low to high. */
    RampBrick(double tableLow, double tableHigh, double low, double high);

    /** The voxel coordinate of a value along the row; across it, kAcross. */
    float placeOf(double value) const;
    static constexpr float kAcross = 0.5f;

    /** The row as a volume of one brick of 16 bits, for the table of the options. */
    VoglVolume makeVolume(voRenderingMode renderingMode) const;

private:
    double tableLow_, tableHigh_;
    int below_, steps_, above_; // voxels below, steps within and voxels above the table's range
};
