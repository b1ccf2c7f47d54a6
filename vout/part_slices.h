#pragma once

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

#include <memory>
#include <vector>

namespace vo {

/// The polygons of one part: a face set for each brick and plane, kept from frame to frame. Each has vertices of
/// its own, which grow.
class PartSlices
{
public:
    /// Room for so many bricks and planes, of records of so many values.
    void fit(int bricks, int planes, int values);
    /// As voGeometryActions::polygonize takes it.
    voIndexedFaceSet*** sets() { return array_.data(); }
    voIndexedFaceSet* of(int brick, int plane) const
    {
        return sets_[static_cast<std::size_t>(brick)][static_cast<std::size_t>(plane)].get();
    }

private:
    int values_ = 0;
    std::vector<std::vector<std::unique_ptr<voIndexedFaceSet>>> sets_;
    std::vector<std::vector<voIndexedFaceSet*>> rows_;
    std::vector<voIndexedFaceSet**> array_;
};

} // namespace vo
