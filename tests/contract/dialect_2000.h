// No guard: included once a dialect, with DIALECT as its name.

#include <vo/Enums.h>

namespace DIALECT {

/// Writes a file through the stream headers from before the standard, reads it back, and puts "..3.14 10 010"
/// into text.
int oldStreams(const char* fileName, char* text, int size);

/// 9 + 6 + 3 + 3 + 0.
int oldContainers();

/// 31312 (formats and type of the call inside), and a million times 1 for _V3F, 2 for POST_INTERPOLATION, 4
/// and 16 always, 8 for AXIS_ALIGNED.
int bareNames(voInterleavedArrayType interleavedArrayFormat, voLookupTableType lookupType,
              voSamplingMode mode);

/// The value of each constant of CompatNames.h in the header's order, then -1000.
const int* everyBareName();

} // namespace DIALECT
