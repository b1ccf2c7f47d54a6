#ifndef VO_COMPAT_NEW_H
#define VO_COMPAT_NEW_H

#include <new>

using std::new_handler;
using std::set_new_handler;

#endif
