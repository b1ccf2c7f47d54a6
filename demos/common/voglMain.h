#pragma once

// Before any header of <vo/...>.
#include "gl.h"

#include "matrices.h"
#include "volume_view/options.h"
#include "screen.h"

#include <vo/Volumizer.h>

#include <vector>

/* What voglMain.cpp, the main program of all vogl demos but voglSimple, shares with the one it drives.

   A program defines what sets it apart, and the guide's five functions (page 157): */

struct VoglProgram
{
    /** For -help: what it does, its arguments besides options, and those of an example. */
    const char* purpose;
    const char* arguments = "VOLUME";
    const char* example;
    /** How many arguments it takes besides options, and what they are, for a message. */
    int leastArguments = 1, mostArguments = 1;
    const char* expected = "the file of one volume";
    /** Options of its own, beside those of all programs. */
    std::vector<vo::OwnOption> options = {};
    /** It draws its polygons in a loop of its own, whatever -engine says. */
    bool ownLoop = false;
    /** Radius of the sphere round all that it draws, in that of the volume. */
    double margin = 1;
    /** For -help: lines on its own keys and buttons; each ends. */
    const char* keys = "";
    /** A button was pressed, or else the pointer dragged with it; x and y run from 0 at the lower left corner
       of the window to 1. True: done; false: it turns the volume, or moves the table, as in all programs. */
    bool (*pointer)(vo::Button button, bool pressed, double x, double y) = nullptr;
    /** A key, in lower case. True: done. */
    bool (*key)(int key) = nullptr;
};
extern const VoglProgram voglProgram;

/** Reads the volume that the command line names (argv[1] and on; options are taken out before) and says how
   it is drawn. No OpenGL yet. Leaves by exit(1) after one line on stderr when it cannot. NULL: the view
   takes its size from the tetrahedra, which begin at the origin. */
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
/** Spacing of the voxels. Without -scale, my_InitAppearance may set it. */
extern float modelScale[3];
/** The view, without the volume's model matrix: for programs that draw from other points too. */
struct VoglView
{
    vo::Model model;
    vo::Orientation orientation;
    vo::ViewVolume volume;
    int width, height;
};
/** That of the frame which is drawn. */
const VoglView& voglView();
/** Where my_DrawVolume's time goes, for -frames. */
extern voutTimer polygonizeTimer, uploadTimer, drawTimer;
/** Prints the error of the library; the frame counts as not drawn. */
void my_ExceptionHandler(void);
