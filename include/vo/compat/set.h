#ifndef VO_COMPAT_SET_H
#define VO_COMPAT_SET_H

#include <set>

using std::multiset;
using std::set;

#endif
