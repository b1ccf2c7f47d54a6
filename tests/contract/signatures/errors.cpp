// R: the class voError (pages 63 and 64), by way of a header that is not its own.

#include <vo/Appearance.h>

#include <iostream>

#include "rows.h"

namespace DIALECT {

static void myExceptionHandler(void)
{
    char text[200];
    snprintf(text, sizeof text, "OpenGL Volumizer error %d: %s\n", voError::getErrorNumber(),
             voError::getErrorString());
}

void errors()
{
    ROW(R1);
    voErrorType number = voError::NO_ERROR;
    number = voErrorTypeScope::NO_ERROR;
    ROW(R2);
    is<voErrorType (*)()>(&voError::getErrorNumber);
    if (voError::getErrorNumber() != voError::NO_ERROR)
        fprintf(stderr, "voError %s\n", voError::getErrorString());
    ROW(R3);
    is<const char* (*)()>(&voError::getErrorString);
    ROW(R4);
    is<void (*)(voErrorType)>(&voError::setErrorNumber);
    is<void (*)(int)>(&voError::setErrorNumber);
    voError::setErrorNumber(number);
    ROW(R5);
    is<void (*)(const char*)>(&voError::setErrorString);
    ROW(R6);
    is<void (*(*)(void (*)(void)))(void)>(&voError::setErrorHandler);
    void (*previous)(void) = voError::setErrorHandler(myExceptionHandler);
    voError::setErrorHandler(previous);
    ROW(R7);
    is<void (*)()>(&voError::callErrorHandler);
    ROW(R8);
    is<void (*)(int)>(&voError::setDebugLevel);
    ROW(R9);
    is<void (*)(FILE*)>(&voError::setDebugStream);
    is<void (*)(std::ostream&)>(&voError::setDebugStream);
}

} // namespace DIALECT
