// The window itself, on a display of its own: Xvfb, which keeps its screen in a file that is read here.
#include "run_program.h"

#include <gtest/gtest.h>

// After GoogleTest: it defines None, True and other plain words.
#include <X11/Xlib.h>
#include <X11/keysym.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>
#include <sys/prctl.h>
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
        prctl(PR_SET_PDEATHSIG, SIGTERM); // a test that is killed leaves nobody behind
        const int file = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, STDERR_FILENO);
        dup2(file, STDOUT_FILENO);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    ~Child()
    {
        if (id_ <= 0) return;
        kill(id_, SIGTERM);
        waitpid(id_, nullptr, 0);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Waits until it leaves by itself, at most a minute; its exit status, or -1.
    int waitForEnd()
    {
        for (int i = 0; i < 600; ++i) {
            int status = 0;
            if (waitpid(id_, &status, WNOHANG) == id_) {
                id_ = 0;
                return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            }
            std::this_thread::sleep_for(100ms);
        }
        return -1;
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

/// A user at the display: the only window there, and what is done to it.
class User
{
public:
    explicit User(const std::string& display) : display_(XOpenDisplay((":" + display).c_str()))
    {
        Window root = 0, parent = 0, *children = nullptr;
        unsigned count = 0;
        XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count);
        for (unsigned i = 0; i < count; ++i) {
            XWindowAttributes attributes;
            XGetWindowAttributes(display_, children[i], &attributes);
            if (attributes.map_state == IsViewable) window_ = children[i];
        }
        if (children) XFree(children);
    }
    ~User() { XCloseDisplay(display_); }
    User(const User&) = delete;
    User& operator=(const User&) = delete;

    void movePointer(int x, int y)
    {
        XWarpPointer(display_, 0, window_, 0, 0, 0, 0, x, y);
        XSync(display_, False);
    }
    void button(unsigned number, bool down)
    {
        XEvent event{};
        event.xbutton.type = down ? ButtonPress : ButtonRelease;
        event.xbutton.button = number;
        send(event);
    }
    void key(KeySym symbol)
    {
        XEvent event{};
        event.xkey.type = KeyPress;
        event.xkey.keycode = XKeysymToKeycode(display_, symbol);
        send(event);
    }
    /// As a window manager does.
    void closeWindow()
    {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
        event.xclient.format = 32;
        event.xclient.data.l[0] = long(XInternAtom(display_, "WM_DELETE_WINDOW", False));
        send(event);
    }
    void resize(unsigned width, unsigned height)
    {
        XResizeWindow(display_, window_, width, height);
        XSync(display_, False);
    }

private:
    void send(XEvent& event)
    {
        event.xkey.window = window_;
        XSendEvent(display_, window_, True, NoEventMask, &event);
        XSync(display_, False);
    }

    Display* display_;
    ::Window window_ = 0;
};

bool installed(const std::string& program)
{
    return std::system(("command -v " + program + " >/dev/null").c_str()) == 0;
}

class WindowTest : public testing::TestWithParam<const char*>
{
protected:
    void SetUp() override
    {
        if (!installed("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
        vo::writeBytes(folder / "blob.tif", 24, 20, 16, [](int x, int y, int z) {
            return std::max(0,
                            250 - 3 * ((x - 9) * (x - 9) + 2 * (y - 12) * (y - 12) + 3 * (z - 6) * (z - 6)));
        });
        vo::writeBytes(folder / "tags.tif", 24, 20, 16, [](int x, int, int) { return x / 8; });
        std::ofstream(folder / "bare.raw") << std::string(512, 'x');
        std::ofstream(folder / "cell.node") << "4 3 1 0\n0 0 0 0 1\n1 9 0 0 2\n2 0 8 0 3\n3 0 0 7 4\n";
        std::ofstream(folder / "cell.ele") << "1 4 0\n0 0 1 2 3\n";
        displayNumber = startDisplay();
        ASSERT_NE(displayNumber, "") << vo::readFile(folder / "Xvfb.log");
    }

    /// Starts Xvfb on a free display; its number, or "" when it does not start.
    std::string startDisplay()
    {
        int ends[2];
        if (pipe(ends) != 0) return "";
        display = std::make_unique<Child>(
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

    std::unique_ptr<Child>
    startProgram(const std::string& words = "voglBasic blob.tif -view 20 30 -size 200 200")
    {
        std::vector<std::string> line{
            "env", "-C", folder.path(), "DISPLAY=:" + displayNumber,
            // Mesa's GLX leaks, under no name that could be excepted: it is unloaded by then.
            "ASAN_OPTIONS=detect_leaks=0"};
        std::istringstream stream(std::string(VOLUMIZER_PROGRAMS) + "/" + words + " " + GetParam());
        for (std::string word; stream >> word;)
            line.push_back(word);
        return std::make_unique<Child>(line, folder / "window.log");
    }

    /// Expects that the window comes to show, within 1, what the words draw without a window.
    void expectShown(const std::string& words, const std::string& program = "voglBasic blob.tif")
    {
        const std::size_t space = std::min(program.find(' '), program.size());
        const auto run =
            folder.run(program.substr(0, space),
                       program.substr(space) + " -output picture.png " + words + " " + GetParam());
        ASSERT_EQ(run.status, 0) << run.errors;
        const auto expected = vo::readPng(folder / "picture.png");
        ASSERT_TRUE(expected);
        ASSERT_GT(*std::max_element(expected->bytes.begin(), expected->bytes.end()), 50);
        vo::PictureDifference apart{255, 0};
        for (int i = 0; i < 600 && apart.largest > 1; ++i) {
            const Picture shown = readScreen(folder / "Xvfb_screen0", expected->width, expected->height);
            if (!shown.bytes.empty()) apart = vo::difference(shown, *expected);
            if (apart.largest > 1) std::this_thread::sleep_for(100ms);
        }
        EXPECT_LE(apart.largest, 1) << words << ": " << vo::readFile(folder / "window.log");
    }

    vo::ScratchFolder folder;
    std::unique_ptr<Child> display;
    std::string displayNumber;
};

TEST_P(WindowTest, windowShowsTheFrameThatIsWrittenWithoutOne)
{
    const auto program = startProgram();
    expectShown("-view 20 30 -size 200 200");
    EXPECT_EQ(vo::readFile(folder / "window.log"), "");
}

TEST_P(WindowTest, windowFollowsMouseSizeAndKeys)
{
    const auto program = startProgram();
    expectShown("-view 20 30 -size 200 200");
    User user(displayNumber);

    user.movePointer(100, 100);
    user.button(1, true);
    std::this_thread::sleep_for(200ms);
    user.movePointer(150, 120);
    expectShown("-view 18 25 -size 200 200");
    user.button(1, false);
    std::this_thread::sleep_for(200ms);
    user.movePointer(10, 10);

    user.resize(150, 120);
    expectShown("-view 18 25 -size 150 120");

    user.movePointer(40, 70);
    user.button(2, true);
    std::this_thread::sleep_for(200ms);
    user.movePointer(45, 60); // center 45 / 150, width 2 * 60 / 120 of 0 to 255
    expectShown("-view 18 25 -size 150 120 -lut 76.5 255");
    user.button(2, false);

    user.key(XK_r);
    expectShown("-view 20 30 -size 150 120 -lut 76.5 255");
    user.key(XK_h);
    user.key(XK_Escape);
    EXPECT_EQ(program->waitForEnd(), 0) << vo::readFile(folder / "window.log");
    EXPECT_NE(vo::readFile(folder / "window.log").find("Left drag"), std::string::npos);
}

TEST_P(WindowTest, everyDemoFollowsItsWindow)
{
    struct Demo
    {
        const char* program;
        /// What the right button dragged to 40 25 in a window of 60 x 50 stands for, if anything.
        const char* dragged;
    };
    for (const auto& [program, dragged] :
         {Demo{"voglCache blob.tif", ""}, Demo{"voglRaw 0 8 8 8 uchar bare.raw", ""},
          Demo{"voglSpaceLeap blob.tif 1 255", ""}, Demo{"voglMorph blob.tif", "-twist 60 -bend 0"},
          Demo{"voglSphere blob.tif -center 9 12 6", "-radius 8.831761"}, Demo{"voglUnstructured", ""},
          Demo{"voglMesh cell.node", ""}, Demo{"voglMPR1 blob.tif", ""}, Demo{"voglMPR2 blob.tif", ""},
          Demo{"voglTwo blob.tif blob.tif -offset 6 4 2", ""}, Demo{"voglTagged blob.tif tags.tif", ""},
          Demo{"voglRoam blob.tif", ""}, Demo{"voglMirror blob.tif", ""}, Demo{"voglFan blob.tif", ""},
          Demo{"voglDeform blob.tif -lattice 2 2 2", "-drag 35 30 40 25"},
          Demo{"voglShade blob.tif -lut 100 100", "-light 0.33333333 0 0.94280904"}}) {
        {
            const auto running = startProgram(program + std::string(" -size 50 60"));
            expectShown("-size 50 60", program);
            User user(displayNumber);
            user.resize(60, 50);
            expectShown("-size 60 50", program);
            if (*dragged) {
                user.movePointer(35, 20);
                user.button(3, true);
                std::this_thread::sleep_for(200ms);
                user.movePointer(40, 25);
                expectShown(dragged + std::string(" -size 60 50"), program);
                user.button(3, false);
                user.movePointer(1, 1);
            }
            user.key(XK_Escape);
            EXPECT_EQ(running->waitForEnd(), 0) << program << vo::readFile(folder / "window.log");
        }
        const auto running = startProgram(program + std::string(" -size 50 60"));
        expectShown("-size 50 60", program);
        User(displayNumber).closeWindow();
        EXPECT_EQ(running->waitForEnd(), 0) << program << vo::readFile(folder / "window.log");
    }
}

TEST_P(WindowTest, keysMoveTheCubeOfInterest)
{
    const std::string words = "voglRoam blob.tif -bricks 2 2 2 -size 60 50 -voi 8 8 8 8";
    const auto running = startProgram(words);
    expectShown("", words);
    User user(displayNumber);
    for (const KeySym key : {XK_l, XK_o, XK_k, XK_equal})
        user.key(key);
    expectShown("-voi 9 9 7 10", words);
    // By an eighth of ten; then a smaller cube.
    for (const KeySym key : {XK_j, XK_u, XK_i, XK_minus})
        user.key(key);
    expectShown("-voi 7.75 7.75 8.25 8", words);
    user.key(XK_Escape);
    EXPECT_EQ(running->waitForEnd(), 0);
    EXPECT_NE(vo::readFile(folder / "window.log").find(" of 8 bricks: "), std::string::npos);
}

TEST_P(WindowTest, middleButtonMovesTheBall)
{
    const std::string words = "voglMirror blob.tif -size 60 60 -view 0 30 -sphere 12 10 8";
    const auto running = startProgram(words);
    expectShown("", words);
    User user(displayNumber);
    user.movePointer(30, 30);
    user.button(2, true);
    std::this_thread::sleep_for(200ms);
    user.movePointer(36, 27);
    // Half the window is 1.5 times half the diagonal; to the right is along x turned by 30 degrees, up is z.
    const double pixel = 1.5 * std::sqrt(24.0 * 24 + 20 * 20 + 16 * 16) / 60;
    const double turn = 30 * std::numbers::pi / 180;
    expectShown("-sphere " + std::to_string(12 + 6 * pixel * std::cos(turn)) + " " +
                    std::to_string(10 + 6 * pixel * std::sin(turn)) + " " + std::to_string(8 + 3 * pixel),
                words);
    user.button(2, false);
}

INSTANTIATE_TEST_SUITE_P(BothProfiles, WindowTest, testing::Values("", "-core"),
                         [](const auto& profile) { return *profile.param ? "core" : "compatibility"; });

} // namespace
