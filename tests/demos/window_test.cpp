// The window itself, on a display of its own: Xvfb, which keeps its screen in a file that is read here.
#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

using vo::Picture;
using namespace std::chrono_literals;

/// A child process, ended with this object.
class Child
{
public:
    Child(const std::vector<std::string>& words, const std::string& errors)
    {
        std::vector<char*> arguments;
        for (const std::string& word : words)
            arguments.push_back(const_cast<char*>(word.c_str()));
        arguments.push_back(nullptr);
        id_ = fork();
        if (id_ != 0) return;
        const int file = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, STDERR_FILENO);
        dup2(file, STDOUT_FILENO);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    ~Child() { end(); }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    void end()
    {
        if (id_ <= 0) return;
        kill(id_, SIGTERM);
        waitpid(id_, nullptr, 0);
        id_ = 0;
    }

private:
    pid_t id_ = 0;
};

/// The upper left width x height pixels of the screen that Xvfb keeps in `file`, in the X window dump format
/// with 32 bits a pixel; empty while it is not there.
Picture readScreen(const std::filesystem::path& file, int width, int height)
{
    const std::string dump = vo::readFile(file);
    const auto word = [&dump](std::size_t index) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8 | std::uint8_t(dump[4 * index + i]);
        return value;
    };
    if (dump.size() < 100) return {};
    // Words of the header: 0 its length, 7 byte order (0: lowest first), 11 bits a pixel, 12 bytes a line,
    // 19 colours in the map of 12 bytes each that lies before the pixels.
    const std::size_t line = word(12), first = word(0) + 12 * std::size_t(word(19));
    if (word(11) != 32 || word(7) != 0 || dump.size() < first + line * std::size_t(height)) return {};
    Picture picture{width, height, 3, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t at = first + line * std::size_t(y) + 4 * std::size_t(x);
            for (const std::size_t byte : {2, 1, 0}) // blue, green, red in memory
                picture.bytes.push_back(std::uint8_t(dump[at + byte]));
        }
    }
    return picture;
}

bool installed(const std::string& program)
{
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

class WindowTest : public testing::TestWithParam<const char*>
{
protected:
    static constexpr int kSize = 200;

    /// Starts Xvfb on a free display; its number, or "" when it does not start.
    std::string startDisplay()
    {
        int ends[2];
        if (pipe(ends) != 0) return "";
        display_ = std::make_unique<Child>(
            std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                                     "320x240x24", "-fbdir", folder.path(), "-nolisten", "tcp"},
            folder / "Xvfb.log");
        close(ends[1]);
        std::string number;
        for (char digit = 0; read(ends[0], &digit, 1) == 1 && digit != '\n';)
            number += digit;
        close(ends[0]);
        return number;
    }

    /// Waits until the window shows `expected` within 1, at most a minute; what the screen showed last.
    Picture waitForPicture(const Picture& expected)
    {
        Picture shown;
        for (int i = 0; i < 600; ++i) {
            shown = readScreen(folder / "Xvfb_screen0", kSize, kSize);
            if (!shown.bytes.empty() && vo::difference(shown, expected).largest <= 1) break;
            std::this_thread::sleep_for(100ms);
        }
        return shown;
    }

    vo::ScratchFolder folder;
    std::unique_ptr<Child> display_;
};

TEST_P(WindowTest, windowShowsTheFrameThatIsWrittenWithoutOne)
{
    if (!installed("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
    vo::writeBytes(folder / "blob.tif", 24, 20, 16, [](int x, int y, int z) {
        return std::max(0, 250 - 3 * ((x - 9) * (x - 9) + 2 * (y - 12) * (y - 12) + 3 * (z - 6) * (z - 6)));
    });
    const std::string words = std::string("blob.tif -view 20 30 -size 200 200 ") + GetParam();
    const auto offscreen = folder.run("voglBasic", words + " -output picture.png");
    ASSERT_EQ(offscreen.status, 0) << offscreen.errors;
    const auto expected = vo::readPng(folder / "picture.png");
    ASSERT_TRUE(expected);
    ASSERT_GT(*std::max_element(expected->bytes.begin(), expected->bytes.end()), 50);

    const std::string display = startDisplay();
    ASSERT_NE(display, "") << vo::readFile(folder / "Xvfb.log");
    const std::string program = std::string(VOLUMIZER_PROGRAMS) + "/voglBasic";
    std::vector<std::string> line{
        "env", "DISPLAY=:" + display, program, folder / "blob.tif", "-view", "20", "30", "-size", "200",
        "200"};
    if (*GetParam()) line.push_back(GetParam());
    const Child window(line, folder / "window.log");
    const Picture shown = waitForPicture(*expected);
    ASSERT_FALSE(shown.bytes.empty()) << "the screen cannot be read";
    const auto apart = vo::difference(shown, *expected);
    EXPECT_LE(apart.largest, 1) << vo::readFile(folder / "window.log");
    EXPECT_EQ(vo::readFile(folder / "window.log"), "");
}

INSTANTIATE_TEST_SUITE_P(BothProfiles, WindowTest, testing::Values("", "-core"),
                         [](const auto& profile) { return *profile.param ? "core" : "compatibility"; });

} // namespace
