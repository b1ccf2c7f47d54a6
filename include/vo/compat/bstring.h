#ifndef VO_COMPAT_BSTRING_H
#define VO_COMPAT_BSTRING_H

/* bcopy, bzero and bcmp, where IRIX declared them. */

#include <string.h>
#include <strings.h>

#endif
