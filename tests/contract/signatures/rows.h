#pragma once

// What the translation units of this folder share. Each uses the signatures of one group of rows exactly as
// the guide prints them, or as its programs use them; pages are the guide's. C++98, compiled in every
// dialect, with DIALECT as the namespace of its one function. Rows are those of checklist.txt.

#include <stdio.h>

/// Notes that the signature of a row was used. In tests/contract/signatures_test.cpp.
void noteRow(const char* row);
#define ROW(id) noteRow(#id)

#include "groups.h"

namespace {

/// Naming a function as a pointer of an exact type compiles only when that very signature exists.
template <class T>
void is(T)
{
}

/// Unscoped: converts to int, is cast back, switched on and printed with %d.
template <class T>
void isOldEnumeration(T value)
{
    int stored = value;
    T back = (T)stored;
    char text[16];
    sprintf(text, "%d", back);
    switch ((int)back) {
    default: break;
    }
}

} // namespace
