#ifndef VO_COMPAT_MAP_H
#define VO_COMPAT_MAP_H

#include <map>

using std::map;
using std::multimap;
using std::pair;

#endif
