#include "expect_error.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

using namespace vo::test;

int calls = 0;
int handlerOneCalls = 0;

void countCall()
{
    ++calls;
}
void handlerOne()
{
    ++handlerOneCalls;
}

void raiseInside()
{
    boundFaceCount(-1);
}

struct ErrorTest : testing::Test
{
    ErrorTest() { calls = handlerOneCalls = 0; }
    ~ErrorTest() override
    {
        voError::setErrorHandler(NULL);
        voError::setDebugLevel(0);
        voError::setDebugStream(stderr);
    }
};

TEST_F(ErrorTest, readingTheNumberResetsItAlone)
{
    raiseInside();
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::BAD_VALUE);
    EXPECT_EQ(voError::getErrorNumber(), voError::NO_ERROR);
    EXPECT_NE(voError::getErrorString(), nullptr);
}

TEST_F(ErrorTest, readingTheStringResetsItAlone)
{
    raiseInside();
    EXPECT_NE(voError::getErrorString(), nullptr);
    EXPECT_EQ(voError::getErrorString(), nullptr);
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::BAD_VALUE);
}

TEST_F(ErrorTest, nothingIsSetAtFirst)
{
    expectNoError();
}

TEST_F(ErrorTest, stringStaysReadableAfterTheReset)
{
    raiseInside();
    const char* text = voError::getErrorString();
    EXPECT_EQ(voError::getErrorString(), nullptr);
    EXPECT_NE(std::string(text).find("boundFaceCount"), std::string::npos);
}

TEST_F(ErrorTest, numberPrintsAsDecimal)
{
    voError::setErrorNumber(voErrorTypeScope::UNSUPPORTED);
    char text[8];
    std::snprintf(text, sizeof text, "%d", voError::getErrorNumber());
    EXPECT_STREQ(text, "4");
}

TEST_F(ErrorTest, settersDoNotCallTheHandler)
{
    voError::setErrorHandler(countCall);
    voError::setErrorNumber(voErrorTypeScope::UNSUPPORTED);
    voError::setErrorNumber(3);
    voError::setErrorString("text");
    EXPECT_EQ(calls, 0);
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::OUT_OF_MEMORY);
}

TEST_F(ErrorTest, setErrorStringCopiesTheText)
{
    std::string text = "before";
    voError::setErrorString(text.c_str());
    text = "after!";
    EXPECT_STREQ(voError::getErrorString(), "before");
    voError::setErrorString("x");
    voError::setErrorString(NULL);
    EXPECT_EQ(voError::getErrorString(), nullptr);
}

TEST_F(ErrorTest, setErrorHandlerReturnsThePreviousOne)
{
    EXPECT_EQ(voError::setErrorHandler(countCall), nullptr);
    EXPECT_EQ(voError::setErrorHandler(handlerOne), &countCall);
    EXPECT_EQ(voError::setErrorHandler(NULL), &handlerOne);
    EXPECT_EQ(voError::setErrorHandler(NULL), nullptr);
}

TEST_F(ErrorTest, handlerIsCalledForErrorsInsideTheLibrary)
{
    voError::setErrorHandler(countCall);
    raiseInside();
    EXPECT_EQ(calls, 1);
    raiseInside();
    EXPECT_EQ(calls, 2);
    voError::setErrorHandler(NULL);
    raiseInside();
    EXPECT_EQ(calls, 2);
}

TEST_F(ErrorTest, callErrorHandlerCallsTheInstalledOne)
{
    voError::callErrorHandler();
    voError::setErrorHandler(countCall);
    voError::callErrorHandler();
    EXPECT_EQ(calls, 1);
}

TEST_F(ErrorTest, handlerSeesNumberAndText)
{
    static voErrorType number;
    static std::string text;
    voError::setErrorHandler([] {
        number = voError::getErrorNumber();
        text = voError::getErrorString();
    });
    raiseInside();
    EXPECT_EQ(number, voErrorTypeScope::BAD_VALUE);
    EXPECT_NE(text.find("tetraCount is -1"), std::string::npos);
    expectNoError();
}

TEST_F(ErrorTest, handlerThatErrsItselfIsNotCalledFromWithin)
{
    voError::setErrorHandler([] {
        ++calls;
        raiseInside();
    });
    raiseInside();
    EXPECT_EQ(calls, 1);
    raiseInside();
    EXPECT_EQ(calls, 2);
}

TEST_F(ErrorTest, handlerMayThrow)
{
    voError::setErrorHandler([] {
        ++calls;
        throw std::runtime_error("stop");
    });
    EXPECT_THROW(raiseInside(), std::runtime_error);
    EXPECT_THROW(raiseInside(), std::runtime_error);
    EXPECT_EQ(calls, 2);
}

TEST_F(ErrorTest, handlerMayReplaceItself)
{
    voError::setErrorHandler([] {
        ++calls;
        voError::setErrorHandler(handlerOne);
    });
    raiseInside();
    raiseInside();
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(handlerOneCalls, 1);
}

TEST_F(ErrorTest, eachThreadHasItsOwnError)
{
    raiseInside();
    voErrorType other = voErrorTypeScope::BAD_ENUM;
    const char* otherText = "";
    std::thread([&] {
        other = voError::getErrorNumber();
        otherText = voError::getErrorString();
        voError::setErrorNumber(voErrorTypeScope::UNSUPPORTED);
    }).join();
    EXPECT_EQ(other, voErrorTypeScope::NO_ERROR);
    EXPECT_EQ(otherText, nullptr);
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::BAD_VALUE);
}

TEST_F(ErrorTest, threadsErrAtTheSameTime)
{
    const auto err = [](int times) {
        for (int i = 0; i < times; ++i) {
            raiseInside();
            EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::BAD_VALUE);
            EXPECT_NE(voError::getErrorString(), nullptr);
        }
    };
    std::thread one(err, 1000), two(err, 1000);
    for (int i = 0; i < 1000; ++i)
        voError::setErrorHandler(i % 2 ? handlerOne : NULL);
    one.join();
    two.join();
}

TEST_F(ErrorTest, debugLevelZeroIsSilent)
{
    std::ostringstream out;
    voError::setDebugStream(out);
    voError::setDebugLevel(0);
    raiseInside();
    EXPECT_EQ(out.str(), "");
}

TEST_F(ErrorTest, higherDebugLevelsPrintErrorsToTheStream)
{
    std::ostringstream out;
    voError::setDebugStream(out);
    voError::setDebugLevel(1);
    raiseInside();
    EXPECT_NE(out.str().find("boundFaceCount: tetraCount is -1"), std::string::npos) << out.str();
}

TEST_F(ErrorTest, extensionsReportAsTheLibraryDoes)
{
    std::ostringstream out;
    voError::setDebugStream(out);
    voError::setDebugLevel(1);
    static int reports = 0;
    voError::setErrorHandler([] { ++reports; });
    voError::report("myAction", voErrorTypeScope::UNSUPPORTED, "not on this machine");
    voError::setErrorHandler(nullptr);
    EXPECT_EQ(reports, 1);
    EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::UNSUPPORTED);
    EXPECT_STREQ(voError::getErrorString(), "myAction: not on this machine");
    EXPECT_NE(out.str().find("myAction: not on this machine"), std::string::npos) << out.str();
}

TEST_F(ErrorTest, debugStreamMayBeAFile)
{
    std::FILE* file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    voError::setDebugStream(file);
    voError::setDebugLevel(1);
    raiseInside();
    voError::setDebugStream(static_cast<FILE*>(NULL));
    EXPECT_GT(std::ftell(file), 10);
    std::fclose(file);
}

TEST_F(ErrorTest, codesAreReachableThroughTheClass)
{
    EXPECT_EQ(voError::NO_ERROR, voErrorTypeScope::NO_ERROR);
    EXPECT_EQ(voError::UNSUPPORTED, voErrorTypeScope::UNSUPPORTED);
}

} // namespace
