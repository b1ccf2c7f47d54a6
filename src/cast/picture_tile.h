#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace vo {

/// Part of a picture, pixels.
struct PictureTile
{
    int x = 0, y = 0, width = 0, height = 0;

    /// The number of one of its pixels, row by row.
    std::size_t pixelAt(int pictureX, int pictureY) const
    {
        return static_cast<std::size_t>(pictureY - y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(pictureX - x);
    }
    std::size_t pixelCount() const
    {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
};

/// The pixels within `tile` that the hull of points may cover: all of them where it reaches behind the eye.
/// Points are pixels of the picture times w, and w.
PictureTile pixelsOf(std::span<const glm::dvec3> points, const PictureTile& tile);

/// A picture in square tiles, row by row; those at its right and its upper edge may be smaller.
class TileGrid
{
public:
    TileGrid() = default;
    TileGrid(int width, int height, int edge) : width_(width), height_(height), edge_(edge) {}

    PictureTile picture() const { return {0, 0, width_, height_}; }
    std::size_t count() const { return across() * static_cast<std::size_t>((height_ + edge_ - 1) / edge_); }
    PictureTile tile(std::size_t number) const;
    /// The number of the tile that has a pixel.
    std::size_t numberAt(int x, int y) const
    {
        return static_cast<std::size_t>(y / edge_) * across() + static_cast<std::size_t>(x / edge_);
    }
    /// Calls visit(number) for the tiles that have pixels of a part of the picture.
    template <class Visit>
    void forTilesOf(const PictureTile& part, const Visit& visit) const
    {
        if (part.width < 1 || part.height < 1) return;
        for (int y = part.y / edge_; y <= (part.y + part.height - 1) / edge_; ++y)
            for (int x = part.x / edge_; x <= (part.x + part.width - 1) / edge_; ++x)
                visit(numberAt(x * edge_, y * edge_));
    }

private:
    std::size_t across() const { return static_cast<std::size_t>((width_ + edge_ - 1) / edge_); }

    int width_ = 0, height_ = 0, edge_ = 1;
};

} // namespace vo
