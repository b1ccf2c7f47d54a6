#ifndef VO_COMPAT_STREAM_H
#define VO_COMPAT_STREAM_H

/* The oldest name of the stream header. */

#include "iostream.h"

#endif
