#ifndef VO_COMPAT_LIST_H
#define VO_COMPAT_LIST_H

#include <list>

using std::list;

#endif
