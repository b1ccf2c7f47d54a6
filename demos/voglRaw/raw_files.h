#pragma once

#include "voglVolume.h"

#include <span>

/** Opens raw files by the arguments HEADER X Y Z TYPE FILE...; one file for each slice, or one for all.
   Leaves by exit(1) after one line on stderr when they do not fit together. */
VoglSource openRawFiles(const char* program, std::span<char* const> arguments, bool bigEndian);
