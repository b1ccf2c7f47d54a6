#pragma once

namespace vo {

/// Where the parts of a vertex record lie, in floats from its start (guide, page 103). -1: not there.
struct RecordLayout
{
    int values = 3;    ///< floats in a record
    int texCoord = -1; ///< three floats
    int color = -1;    ///< `colorChannels` floats
    int colorChannels = 0;

    int position() const { return values - 3; } ///< always the last three floats
    friend bool operator==(const RecordLayout&, const RecordLayout&) = default;
};

} // namespace vo
