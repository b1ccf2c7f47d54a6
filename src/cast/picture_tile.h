#pragma once

namespace vo {

/// Part of a picture, pixels.
struct PictureTile
{
    int x = 0, y = 0, width = 0, height = 0;
};

} // namespace vo
