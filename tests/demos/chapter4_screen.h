#pragma once

/* The window of chapter4_program.cpp, which calls OpenGL by its plain names and so cannot see the loader's
 * header. */

/** Opens a framebuffer without a window, width x height pixels of floats, and makes its context current.
   False after one line on stderr when there is none. */
bool openScreen(int width, int height);
/** Writes what was drawn, as the demos do, and closes. False after one line on stderr when it cannot. */
bool writeScreen(const char* path);
