#ifndef VO_COMPAT_FSTREAM_H
#define VO_COMPAT_FSTREAM_H

/* File streams, as global names. ios::nocreate and ios::noreplace have no successor: leave them out, an ifstream never
   creates a file. */

#include "iostream.h"

#include <fstream>

using std::filebuf;
using std::fstream;
using std::ifstream;
using std::ofstream;

#endif
