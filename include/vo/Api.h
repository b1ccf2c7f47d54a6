#ifndef VO_API_H
#define VO_API_H

/* What every header of the library shares: the export macro, the C headers and stream names that programs of
   1998 expect to arrive through <vo/...>, and the basic types. */

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <GL/gl.h>

#if defined(__has_include)
#if __has_include(<iostream.h>)
#include <iostream.h>
#endif
#endif
#include <iosfwd>

#if defined(_WIN32)
#if defined(VO_BUILDING)
#define VO_API __declspec(dllexport)
#else
#define VO_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define VO_API __attribute__((visibility("default")))
#else
#define VO_API
#endif

/* Programs cast any int to the enumerations; from C++11 on they are told to hold any. */
#if __cplusplus >= 201103L
#define VO_ANY_INT : int
#else
#define VO_ANY_INT
#endif

/** Result and flag type (guide, page 126). Non-zero is true. */
typedef int voBool;

#define VO_FALSE 0
#define VO_TRUE 1

/** Vertices of a tetrahedron (guide, page 76). */
#define VO_TETRA_VERTICES 4

/** Name and version of the library, for printing (guide, page 91). Static storage, never NULL. */
VO_API const char *voVersion();

#endif
