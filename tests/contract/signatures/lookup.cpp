// T: tables (pages 59 to 62).

#include <vo/LookupTable.h>

#include "rows.h"

namespace DIALECT {

void lookup()
{
    ROW(T1);
    ROW(T2);
    ROW(T3);
    ROW(T4);
    static float lookupEntries[2 * 256];
    voTextureLookupPost* aLookupTable = new voTextureLookupPost(
        voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT, 256, voExternalFormatTypeScope::LUMINANCE_ALPHA,
        voDataTypeScope::FLOAT, lookupEntries);
    for (int j1 = 0; j1 < 256; j1++)
        lookupEntries[2 * j1] = lookupEntries[2 * j1 + 1] = 0.5 * (float)j1 / 256.0;
    ROW(T5);
    aLookupTable->load();
    ROW(T6);
    aLookupTable->enable();
    aLookupTable->disable();
    ROW(T7);
    aLookupTable->set(voTextureLookup::LINEAR, 195, 50);
    aLookupTable->set(voLookupTableShapeScope::LINEAR, 195, 50);
    aLookupTable->set(voLookupTableShapeScope::LINEAR, 195.5f, 50.5f);
    ROW(T8);
    is<voLookupTableType (voLookupTable::*)() const>(&voLookupTable::getType);
    ROW(T9);
    is<int (*)(voBrickSetCollection*, voRenderingMode, int, voLookupTableType&, voInternalFormatType&,
               voExternalFormatType&, voDataType&)>(&voLookupTable::getBestParameters);
    ROW(T10);
    voLookupTable* base = aLookupTable;
    delete base;
    // With enumerations in variables, with OpenGL's constants, and with four arguments.
    voInternalFormatType internalFormat = voInternalFormatTypeScope::RGBA8_EXT;
    voExternalFormatType externalFormat = voExternalFormatTypeScope::RGBA;
    voDataType dataType = voDataTypeScope::FLOAT;
    int lookupLength = 256;
    voLookupTablePre pre(internalFormat, lookupLength, externalFormat, dataType);
    voLookupTablePost post(internalFormat, lookupLength, externalFormat, dataType, NULL);
    voLookupTablePre gl(GL_RGBA8, 256, GL_RGBA, GL_FLOAT, lookupEntries);
}

} // namespace DIALECT
