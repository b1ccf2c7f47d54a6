#ifndef VO_COMPAT_DEQUE_H
#define VO_COMPAT_DEQUE_H

#include <deque>

using std::deque;

#endif
