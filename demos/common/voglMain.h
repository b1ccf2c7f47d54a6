#pragma once

// Before any header of <vo/...>.
#include "gl.h"

#include "matrices.h"
#include "options.h"

#include <vo/Volumizer.h>

/* What voglMain.cpp, the main program of all vogl demos but voglSimple, shares with the one it drives.

   A program defines the guide's five functions (page 157): */

/** Reads the volume that the command line names (argv[1]; options are taken out before) and says how it is
   drawn. No OpenGL yet. Leaves by exit(1) after one line on stderr when it cannot. */
voBrickSetCollection* my_InitAppearance(int argc, char** argv);
/** Makes the tetrahedra, and room for what they are cut into. */
voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume);
/** Prepares what needs a context of OpenGL: textures and tables. */
void my_InitGfx(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume);
/** Draws a frame with the matrices that are set. */
void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume);
/** Frees what the others made. */
void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume);

/* and may use: */

/** The command line. */
extern vo::Options options;
/** Spacing of the voxels. */
extern float modelScale[3];
/** Where my_DrawVolume's time goes, for -frames. */
extern voutTimer polygonizeTimer, uploadTimer, drawTimer;
/** Prints the error of the library; the frame counts as not drawn. */
void my_ExceptionHandler(void);
