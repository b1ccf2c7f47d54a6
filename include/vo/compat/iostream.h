#ifndef VO_COMPAT_IOSTREAM_H
#define VO_COMPAT_IOSTREAM_H

/* The stream header from before the standard: its names are global. */

#include <iostream>

using std::cerr;
using std::cin;
using std::clog;
using std::cout;
using std::dec;
using std::endl;
using std::ends;
using std::flush;
using std::hex;
using std::ios;
using std::iostream;
using std::istream;
using std::oct;
using std::ostream;
using std::streambuf;
using std::streamoff;
using std::streampos;
using std::ws;

#endif
