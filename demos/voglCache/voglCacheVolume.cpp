// A volume drawn by drawUtility, which keeps the polygons of a frame for the next ones.
#include "voglCacheVolume.h"

#include "voglFrame.h"
#include "voglLookup.h"

VoglVolume volume;

// How far the view may turn before the polygons are made anew.
static double threshold = 0;
static voDrawActionCache* cache;

vo::OwnOption thresholdOption()
{
    return {"threshold",
            {"DEGREES"},
            "keep the polygons until the view has turned by more than this (default 0: by anything)",
            [](vo::Arguments& arguments) { threshold = arguments.number(0, 180, "an angle in degrees"); }};
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume)
{
    voIndexedTetraSet* aTetraSet = voglBox(volume);
    const int valuesPerVertex = getValuesPerVertex(voInterleavedArrayTypeScope::V3F);
    const int maxVertices = 12 * volume.maxSamplesNumber * volume.maxBrickCount; // a guess, no limit
    cache = new voDrawActionCache(aTetraSet, aVolume, volume.maxSamplesNumber, voglSamplingMode(aVolume),
                                  valuesPerVertex, maxVertices);
    cache->setThreshold(threshold);
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    float samplingPeriod[3];
    voglSamplingPeriod(samplingPeriod);
    const bool is2D = aVolume->getInterpolationType() == voInterpolationTypeScope::_2D;
    const voDecorationFlags decorations = !options.wireframe ? voDecorationFlagsScope::NONE
                                          : is2D             ? voDecorationFlagsScope::TETRAS
                                                             : voDecorationFlagsScope::ALL;
    voglBeginBlending();
    // drawUtility draws the outlines too: they hide what lies behind them. Slices come back to front, and
    // hide nothing that comes later.
    if (options.wireframe) gl->DepthMask(GL_TRUE);
    if (options.engine)
        voState::setEngine(*options.engine == vo::Options::Engine::Cast ? voEngineScope::CAST
                                                                        : voEngineScope::SLICES);
    drawTimer.start();
    voGeometryActions::drawUtility(aTetraSet, voInterleavedArrayTypeScope::V3F, aVolume, cache,
                                   options.viewSpace ? voSamplingSpaceScope::VIEW_VOLUME
                                                     : voSamplingSpaceScope::OBJECT,
                                   samplingPeriod, decorations);
    drawTimer.stop();
    voglEndBlending();
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete cache;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
