#include "core/log.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace {

/// Messages go to `text` while it lives.
struct Listening
{
    std::ostringstream text;
    int before = vo::debugLevel();

    explicit Listening(int level)
    {
        vo::setDebugLevel(level);
        vo::setDebugStream(&text);
    }
    ~Listening()
    {
        vo::setDebugStream(static_cast<std::ostream*>(nullptr));
        vo::setDebugLevel(before);
    }
};

} // namespace

TEST(Log, messagesUpToTheLevelArePrinted)
{
    Listening listening(1);
    vo::debug(1, "near");
    vo::debug(2, "far");
    EXPECT_EQ(listening.text.str(), "near\n");
}

TEST(Log, levelZeroIsSilent)
{
    Listening listening(0);
    vo::debug(1, "near");
    EXPECT_EQ(listening.text.str(), "");
}

TEST(Log, theLastStreamReceivesTheMessages)
{
    Listening listening(1);
    std::FILE* file = std::tmpfile();
    ASSERT_NE(file, nullptr);
    vo::setDebugStream(file);
    vo::debug(1, "to the file");
    std::rewind(file);
    char line[32]{};
    EXPECT_NE(std::fgets(line, sizeof line, file), nullptr);
    EXPECT_STREQ(line, "to the file\n");
    EXPECT_EQ(listening.text.str(), "");
    vo::setDebugStream(static_cast<std::FILE*>(nullptr));
    std::fclose(file);
}

/// In a process of its own: the level is read once.
TEST(LogDeathTest, environmentGivesTheFirstLevelAndWhatIsNoneIsTold)
{
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            setenv("VO_DEBUG", "2", 1);
            std::exit(vo::debugLevel());
        },
        testing::ExitedWithCode(2), testing::Eq(""));
    EXPECT_EXIT(
        {
            setenv("VO_DEBUG", "2\nx", 1);
            std::exit(vo::debugLevel());
        },
        testing::ExitedWithCode(0),
        testing::Eq("VO_DEBUG: expected a whole number, found \"2.x\", which has no effect\n"));
}
