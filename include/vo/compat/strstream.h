#ifndef VO_COMPAT_STRSTREAM_H
#define VO_COMPAT_STRSTREAM_H

/* Streams over arrays of char, as global names. The standard's header warns that it is out of date, which whoever
   includes this one knows. */

#include "iostream.h"

#pragma push_macro("__DEPRECATED")
#undef __DEPRECATED
#include <strstream>
#pragma pop_macro("__DEPRECATED")

using std::istrstream;
using std::ostrstream;
using std::strstream;
using std::strstreambuf;

#endif
