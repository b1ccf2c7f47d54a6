#include <vo/Api.h>

const char* voVersion()
{
    return "Volumizer " VOLUMIZER_VERSION;
}
