#ifndef VO_COMPAT_VECTOR_H
#define VO_COMPAT_VECTOR_H

#include <vector>

using std::vector;

#endif
