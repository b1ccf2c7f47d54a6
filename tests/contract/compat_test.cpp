// The dialect of 2000: headers from before the standard, and CompatNames.h.

#include <vo/Enums.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../util/scratch_folder.h"

#define DIALECT cxx98
#include "dialect_2000.h"
#undef DIALECT
#define DIALECT cxx20
#include "dialect_2000.h"

namespace {

using vo::ScratchFolder;

void expectOldStreams(int (*oldStreams)(const char*, char*, int))
{
    ScratchFolder folder;
    char text[80];
    EXPECT_EQ(oldStreams((folder / "out.txt").c_str(), text, sizeof text), 1);
    EXPECT_EQ(std::string(text), "..3.14 10 010");
}

TEST(CompatTest, streamsFromBeforeTheStandardAreGlobal)
{
    expectOldStreams(cxx98::oldStreams);
    expectOldStreams(cxx20::oldStreams);
}

TEST(CompatTest, containersFromBeforeTheStandardAreGlobal)
{
    EXPECT_EQ(cxx98::oldContainers(), 9 + 6 + 3 + 3);
    EXPECT_EQ(cxx20::oldContainers(), 9 + 6 + 3 + 3);
}

TEST(CompatTest, bareNamesOfTheGuideFitTheirTypes)
{
    for (const auto bareNames : {cxx98::bareNames, cxx20::bareNames}) {
        const int always = 10000 * 3 + 100 * 2 + 12 + 20000000;
        EXPECT_EQ(bareNames(voInterleavedArrayTypeScope::V3F, voLookupTableTypeScope::PRE_INTERPOLATION,
                            voSamplingModeScope::AXIS_ALIGNED),
                  always + 1000000 + 8000000);
        EXPECT_EQ(bareNames(voInterleavedArrayTypeScope::T3F_V3F, voLookupTableTypeScope::POST_INTERPOLATION,
                            voSamplingModeScope::SPHERICAL),
                  always + 2000000);
    }
}

TEST(CompatTest, everyBareNameHasItsValue)
{
    // By the order of declaration in the guide; a line for each enumeration of CompatNames.h.
    const std::vector<int> expected{
        1, 2,                                         // _2D, _3D
        1, 2,                                         // MONOCHROME, COLOR
        1, 3, 4, 6, 7, 8, 10, 11, 10, 11,             // UNSIGNED_BYTE ...
        1, 2, 3, 4, 5, 6, 9,  4,  6,  9,  7,  8,  10, // INTENSITY8_EXT ...
        1, 2, 3, 4, 5,                                // INTENSITY ...
        1, 2, 3,                                      // TRUNCATE ...
        1, 2, 4, 3,                                   // INTERLEAVE, TEXTURE_OBJECTS, PRE_TRANSPOSE, BEST
        0, 1, 2, 3,                                   // UNSPECIFIED ...
        1, 2, 3,                                      // VIEWPORT_ALIGNED ...
        1, 2, 3,                                      // VIEW_VOLUME ...
        0, 1, 2, 3, 4, 5, 6,                          // V3F ...
        1, 2, 3, 4,                                   // BAD_VALUE ...
        1, 2,                                         // PRE_INTERPOLATION, POST_INTERPOLATION
        0,                                            // LINEAR
        1, 2, 3,                                      // BRICKS, TETRAS, ALL
        0, 1, 2, 3, 4, 5, 6,  7,  8,  9,  10, 11, 12, // _DATA_TYPE_DEFAULT ...
        0, 1, 2, 3, 4, 5, 6,                          // _V3F ...
        1, 2, 3,                                      // _SAMPLE_OVER_VIEW_VOLUME ...
        1, 2, 3, 1, 2, 3,                             // _SAMPLING_..., VO_SAMPLING_...
    };
    for (const int* values : {cxx98::everyBareName(), cxx20::everyBareName()}) {
        std::vector<int> found;
        for (; *values != -1000; ++values)
            found.push_back(*values);
        EXPECT_EQ(found, expected);
    }
}

} // namespace
