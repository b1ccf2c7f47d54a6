#pragma once

#include <span>

namespace vo {

/// Receives polygons as they are made.
class FaceSink
{
public:
    virtual ~FaceSink() = default;

    /// Appends one convex polygon: whole records, in order round it, for brick `brick` and sample `sample`.
    /// Returns false when there is no room; nothing was appended then.
    virtual bool append(int brick, int sample, std::span<const float> records) = 0;
};

} // namespace vo
