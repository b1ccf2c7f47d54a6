#include "legacy/report.h"

#include "core/log.h"

#include <atomic>
#include <optional>
#include <utility>

namespace {

struct LastError
{
    voErrorType number = voErrorTypeScope::NO_ERROR;
    std::optional<std::string> text;
    std::string handedOut; ///< keeps the last text alive for the caller
};

LastError& lastError()
{
    thread_local LastError error;
    return error;
}

std::atomic<void (*)()> errorHandler{nullptr};

} // namespace

voErrorType voError::getErrorNumber()
{
    return std::exchange(lastError().number, NO_ERROR);
}

const char* voError::getErrorString()
{
    LastError& error = lastError();
    if (!error.text) return nullptr;
    error.handedOut = std::move(*error.text);
    error.text.reset();
    return error.handedOut.c_str();
}

void voError::setErrorNumber(voErrorType number)
{
    lastError().number = number;
}

void voError::setErrorNumber(int number)
{
    lastError().number = static_cast<voErrorType>(number);
}

void voError::setErrorString(const char* text)
{
    if (text)
        lastError().text = text;
    else
        lastError().text.reset();
}

void (*voError::setErrorHandler(void (*handler)(void)))(void)
{
    return errorHandler.exchange(handler);
}

void voError::callErrorHandler()
{
    // A handler may call the library; an error there is recorded, but does not call it again from within.
    thread_local bool inHandler = false;
    void (*const handler)() = errorHandler.load();
    if (!handler || inHandler) return;
    struct Scope
    {
        Scope() { inHandler = true; }
        ~Scope() { inHandler = false; } // also when the handler throws
    } const scope;
    handler();
}

void voError::setDebugLevel(int level)
{
    vo::setDebugLevel(level);
}

void voError::setDebugStream(FILE* stream)
{
    vo::setDebugStream(stream);
}

void voError::setDebugStream(std::ostream& stream)
{
    vo::setDebugStream(&stream);
}

void voError::report(const char* action, voErrorType number, const char* text)
{
    const std::string line = std::string(action ? action : "") + ": " + (text ? text : "");
    vo::debug(1, line);
    setErrorNumber(number);
    setErrorString(line.c_str());
    callErrorHandler();
}
