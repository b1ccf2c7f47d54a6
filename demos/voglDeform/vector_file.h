#pragma once

#include "volume_io/result.h"

#include <string>
#include <vector>

/** Vectors of three parts, x fastest, then y, then z. */
struct VectorGrid
{
    int size[3] = {1, 1, 1};
    std::vector<float> parts;
};

/** Reads a volume of three channels in any format of volume_io (docs/formats.md). Of NIfTI and other files
   that say how they lie in the patient the grid arrives turned; parts stay as they are, whatever the type. */
vo::Result<VectorGrid> readVectors(const std::string& fileName);
