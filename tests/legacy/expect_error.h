#pragma once

#include <vo/Error.h>

#include <gtest/gtest.h>

#include <string>

namespace vo::test {

/// The last error has this number and its text holds `part`. Both are read, and so reset.
inline void expectError(voErrorType number, const std::string& part)
{
    EXPECT_EQ(voError::getErrorNumber(), number);
    const char* text = voError::getErrorString();
    ASSERT_NE(text, nullptr);
    EXPECT_NE(std::string(text).find(part), std::string::npos) << text;
}

inline void expectBadValue(const std::string& part = "")
{
    expectError(voErrorTypeScope::BAD_VALUE, part);
}
inline void expectBadEnum(const std::string& part = "has no value")
{
    expectError(voErrorTypeScope::BAD_ENUM, part);
}
inline void expectUnsupported(const std::string& part = "")
{
    expectError(voErrorTypeScope::UNSUPPORTED, part);
}

inline void expectNoError()
{
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::NO_ERROR);
    const char* text = voError::getErrorString();
    EXPECT_EQ(text, nullptr) << text;
}

} // namespace vo::test
