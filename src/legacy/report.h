#pragma once

#include <vo/Error.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace vo {

/// The caller's mistake: becomes a voError where the face is left.
struct CallerError
{
    voErrorType number;
    std::string text;
};

[[noreturn]] inline void badValue(const std::string& text)
{
    throw CallerError{voErrorTypeScope::BAD_VALUE, text};
}
[[noreturn]] inline void badEnum(const std::string& text)
{
    throw CallerError{voErrorTypeScope::BAD_ENUM, text};
}
[[noreturn]] inline void unsupported(const std::string& text)
{
    throw CallerError{voErrorTypeScope::UNSUPPORTED, text};
}

/// The argument, which must not be NULL.
template <typename T>
T& required(T* argument, const char* name)
{
    if (!argument) badValue(std::string(name) + " is NULL");
    return *argument;
}

/// voError::report, for texts made here.
inline void report(const char* action, voErrorType number, const std::string& text)
{
    voError::report(action, number, text.c_str());
}

/// Runs the body of an action; what it throws becomes a voError and the answer 1. Returns 0 otherwise.
template <typename Body>
int guarded(const char* action, Body body)
{
    try {
        body();
        return 0;
    } catch (const CallerError& error) {
        report(action, error.number, error.text);
    } catch (const std::bad_alloc&) {
        report(action, voErrorTypeScope::OUT_OF_MEMORY, "there is not enough memory");
    } catch (const std::length_error&) { // more than any memory holds
        report(action, voErrorTypeScope::OUT_OF_MEMORY, "there is not enough memory");
    } catch (const std::exception& error) {
        report(action, voErrorTypeScope::UNSUPPORTED, error.what());
    }
    return 1;
}

} // namespace vo
