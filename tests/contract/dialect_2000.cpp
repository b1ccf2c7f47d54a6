// What sources of 2000 include and spell, beyond tests/legacy/compile/dialect_1998.cpp: the headers from
// before the standard with their global names, and enumerators without their class. Compiled as C++98 with
// -fpermissive and, for whoever has come further, as C++20 with all warnings; include/vo/compat on the path.

#include <fstream.h>
#include <iomanip.h>
#include <strstream.h>
#include <stream.h>
#include <new.h>
#include <bstring.h>
#include <algo.h>
#include <deque.h>
#include <list.h>
#include <map.h>
#include <set.h>
#include <vector.h>
#include <vo/Volumizer.h>
#include <vo/CompatNames.h>

#include "dialect_2000.h"

namespace DIALECT {

// Each line is one header's doing.
int oldStreams(const char* fileName, char* text, int size)
{
    ofstream out(fileName, ios::out);
    out << setw(6) << setfill('.') << setprecision(3) << 3.14159 << endl
        << hex << 255 << dec << ends << flush;
    out.close();
    char line[80];
    ifstream in(fileName);
    in >> ws;
    in.getline(line, sizeof line);
    ostrstream joined(text, size);
    joined << line << ' ' << setbase(8) << 8 << setiosflags(ios::showbase) << ' ' << 8 << ends;
    istrstream words(text);
    char first[80];
    words >> first;
    cerr << "";
    cout.flush();
    clog.flush();
    istream& input = cin;
    ostream& output = cout;
    iostream* both = NULL;
    streambuf* buffer = output.rdbuf();
    return strcmp(first, line) == 0 && buffer && !both && &input == &cin;
}

int oldContainers()
{
    vector<int> values;
    values.push_back(3);
    values.push_back(1);
    values.push_back(2);
    sort(values.begin(), values.end());
    list<int> copies(values.begin(), values.end());
    deque<int> ends(values.begin(), values.end());
    set<int> different(values.begin(), values.end());
    map<int, int> squares;
    for (unsigned i = 0; i < values.size(); i++)
        squares[values[i]] = values[i] * values[i];
    pair<int, int> last = *squares.rbegin();
    int sum = accumulate(copies.begin(), copies.end(), 0);
    char zeroed[4] = {1, 2, 3, 4};
    bzero(zeroed, sizeof zeroed);
    new_handler before = set_new_handler(0);
    set_new_handler(before);
    return last.second + sum + ends.back() + (int)different.size() + max(zeroed[0], zeroed[3]);
}

// A function of each type: what a bare name is passed to must fit.
static int number(voInternalFormatType internalFormat, voExternalFormatType externalFormat,
                  voDataType dataType)
{
    return 10000 * internalFormat + 100 * externalFormat + dataType;
}

// The spellings of pages 42 to 44, 61, 62, 134, 140 and 143.
int bareNames(voInterleavedArrayType interleavedArrayFormat, voLookupTableType lookupType,
              voSamplingMode mode)
{
    int result = number(LUMINANCE8_ALPHA8_EXT, LUMINANCE_ALPHA, _DATA_TYPE_FLOAT);
    if (interleavedArrayFormat == _V3F) result += 1000000;
    if (lookupType == POST_INTERPOLATION) result += 2000000;
    if (_DATA_TYPE_UNSIGNED_BYTE == UNSIGNED_BYTE && INTENSITY == voExternalFormatTypeScope::INTENSITY)
        result += 4000000;
    switch (mode) {
    case AXIS_ALIGNED: result += 8000000; break;
    default: break;
    }
    if (_SAMPLING_AXIS_ALIGNED == VO_SAMPLING_AXIS_ALIGNED && _SAMPLE_OVER_OBJECT == OBJECT)
        result += 16000000;
    return result;
}

// Every bare name, to be compared with the scoped values.
const int* everyBareName()
{
    static const int values[] = {
        _2D, _3D, MONOCHROME, COLOR, UNSIGNED_BYTE, UNSIGNED_BYTE_3_3_2_EXT, UNSIGNED_SHORT,
        UNSIGNED_SHORT_4_4_4_4_EXT, UNSIGNED_SHORT_5_5_5_1_EXT, UNSIGNED_INT, UNSIGNED_INT_8_8_8_8_EXT,
        UNSIGNED_INT_10_10_10_2_EXT, INT_8_8_8_8_EXT, INT_10_10_10_2_EXT, INTENSITY8_EXT, LUMINANCE8_EXT,
        LUMINANCE8_ALPHA8_EXT, RGBA8_EXT, RGB8_EXT, RGBA4_EXT, RGB4_EXT, RGB88_EXT, RGB84_EXT, RGB44_EXT,
        QUAD_LUMINANCE8_SGIS, DUAL_LUMINANCE_ALPHA8_SGIS, DUAL_INTENSITY8_SGIS, INTENSITY, LUMINANCE_ALPHA,
        LUMINANCE, RGBA, ABGR_EXT, TRUNCATE, AUGMENT, AUGMENT_TIGHT, INTERLEAVE, TEXTURE_OBJECTS,
        PRE_TRANSPOSE, BEST, UNSPECIFIED, XY, XZ, YZ, VIEWPORT_ALIGNED, AXIS_ALIGNED, SPHERICAL, VIEW_VOLUME,
        OBJECT, PRIMITIVE, V3F, T3F_V3F, C3F_V3F, C4F_V3F, T3F_C3F_V3F, T3F_C4F_V3F, USER_V3F, BAD_VALUE,
        BAD_ENUM, OUT_OF_MEMORY, UNSUPPORTED, PRE_INTERPOLATION, POST_INTERPOLATION, LINEAR, BRICKS, TETRAS,
        ALL,
        // With prefixes.
        _DATA_TYPE_DEFAULT, _DATA_TYPE_UNSIGNED_BYTE, _DATA_TYPE_BYTE, _DATA_TYPE_UNSIGNED_BYTE_3_3_2_EXT,
        _DATA_TYPE_UNSIGNED_SHORT, _DATA_TYPE_SHORT, _DATA_TYPE_UNSIGNED_SHORT_4_4_4_4_EXT,
        _DATA_TYPE_UNSIGNED_SHORT_5_5_5_1_EXT, _DATA_TYPE_UNSIGNED_INT, _DATA_TYPE_INT,
        _DATA_TYPE_UNSIGNED_INT_8_8_8_8_EXT, _DATA_TYPE_UNSIGNED_INT_10_10_10_2_EXT, _DATA_TYPE_FLOAT, _V3F,
        _T3F_V3F, _C3F_V3F, _C4F_V3F, _T3F_C3F_V3F, _T3F_C4F_V3F, _USER_V3F, _SAMPLE_OVER_VIEW_VOLUME,
        _SAMPLE_OVER_OBJECT, _SAMPLE_OVER_PRIMITIVE, _SAMPLING_VIEWPORT_ALIGNED, _SAMPLING_AXIS_ALIGNED,
        _SAMPLING_SPHERICAL, VO_SAMPLING_VIEWPORT_ALIGNED, VO_SAMPLING_AXIS_ALIGNED, VO_SAMPLING_SPHERICAL,
        -1000};
    return values;
}

} // namespace DIALECT
