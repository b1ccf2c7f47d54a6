// voglRaw: as voglCache, with a volume from raw files: voxels in row-major order after a header.
#include "raw_files.h"
#include "voglCacheVolume.h"

#include <climits>

static bool bigEndian = false;

const VoglProgram voglProgram = {
    .purpose =
        "Draws a volume from raw files as voglCache does: one file for each slice, in order, or one for\n"
        "all. Each begins with a header of HEADER bytes, which are passed over; then come voxels, x\n"
        "fastest, of TYPE uchar (or ubyte), char, ushort, short or float, lowest byte first.",
    .arguments = "HEADER X Y Z TYPE FILE...",
    .example = "0 256 256 128 ushort -dataRange 0 4095 -lut 135 155 vol*.ima",
    .leastArguments = 6,
    .mostArguments = INT_MAX,
    .expected = "HEADER X Y Z TYPE and one file or one for each slice",
    .options = {thresholdOption(),
                {"bigEndian",
                 {},
                 "the files hold the highest byte first",
                 [](vo::Arguments&) { bigEndian = true; }}},
};

voBrickSetCollection* my_InitAppearance(int argc, char** argv)
{
    volume = voglReadVolume(argv[0], openRawFiles(argv[0], {argv + 1, argv + argc}, bigEndian));
    return volume.bricks;
}
