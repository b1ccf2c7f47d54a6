#pragma once

#include <vo/Volumizer.h>

/* The table of the vogl programs: a file's (-lutFile), or a grey ramp (-lut, or the whole data range) that
   the middle mouse button moves. The ramp's alpha rises with its grey, from 0 to the opacity at which a tenth
   of the volume's longest side, all of it at the ramp's top, lets 1/e of the light through: so that the
   inside shows, however far apart the slices are. */

/** Reads the file of -lutFile, if any, and settles -color and -monochrome: without either, a table with
   colours asks for RGBA. Leaves by exit(1) after one line on stderr when the file cannot be read. */
voRenderingMode readLookupTable(const char* program);

/** Makes the table and enables it. It begins and ends at these values of the file. Volumes of several
   channels bring their own colours and opacities, and get no table unless one is asked for. */
void initLookupTable(voBrickSetCollection* aVolume, voRenderingMode renderingMode, double low, double high);

/** Moves the ramp; in parts of the data range. Nothing happens with a table from a file, or without a table.
 */
void moveLookupRamp(double center, double width);

void deleteLookupTable();
