#ifndef VO_COMPAT_ALGO_H
#define VO_COMPAT_ALGO_H

/* Algorithms of the template library from before the standard, as global names: those that have no namesakes in the
   headers of C. */

#include <algorithm>
#include <functional>
#include <numeric>

using std::accumulate;
using std::copy;
using std::fill;
using std::find;
using std::find_if;
using std::for_each;
using std::greater;
using std::less;
using std::lower_bound;
using std::max;
using std::max_element;
using std::min;
using std::min_element;
using std::reverse;
using std::sort;
using std::stable_sort;
using std::swap;
using std::transform;
using std::unique;
using std::upper_bound;

#endif
