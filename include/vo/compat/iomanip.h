#ifndef VO_COMPAT_IOMANIP_H
#define VO_COMPAT_IOMANIP_H

/* Manipulators with an argument, as global names. */

#include "iostream.h"

#include <iomanip>

using std::resetiosflags;
using std::setbase;
using std::setfill;
using std::setiosflags;
using std::setprecision;
using std::setw;

#endif
