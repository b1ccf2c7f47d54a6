// voglCache: as voglBasic, with polygons that are kept from frame to frame, and all of a frame in one call.
#include "voglCacheVolume.h"

const VoglProgram voglProgram = {
    .purpose = "Draws a volume as voglBasic does, by drawUtility: it keeps the polygons of a frame and cuts\n"
               "the volume anew only when the view has turned by more than -threshold.",
    .example = "head.tif -color -lutFile brain.lut -threshold 5 -frames 36",
    .options = {thresholdOption()},
};

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1]));
    return volume.bricks;
}
