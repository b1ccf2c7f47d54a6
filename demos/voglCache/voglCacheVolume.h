#pragma once

#include "voglMain.h"

#include "voglVolume.h"

/* What voglCache and voglRaw share: all but their my_InitAppearance. */

/** The volume, which my_InitAppearance reads. */
extern VoglVolume volume;

/** The option -threshold. */
vo::OwnOption thresholdOption();
