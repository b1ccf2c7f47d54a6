#include "bench_worker.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <sys/resource.h>
#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace bench {

Clocks clocks()
{
    timespec cpu{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    return {std::chrono::duration<double>(wall).count(),
            static_cast<double>(cpu.tv_sec) + 1e-9 * static_cast<double>(cpu.tv_nsec) +
                seconds(children.ru_utime) + seconds(children.ru_stime)};
}

namespace {

/// Seconds of two million steps that each need the one before: how fast the processor runs just now.
double plainLoop()
{
    const double begin = clocks().wall;
    for (volatile int left = 2'000'000; left > 0;)
        left = left - 1;
    return clocks().wall - begin;
}

void writePicture(const Worker& worker, const std::string& path)
{
    const std::vector<float> pixels = worker.picture ? worker.picture() : std::vector<float>();
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(pixels.data()),
               static_cast<std::streamsize>(pixels.size() * sizeof(float)));
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

} // namespace

int serve(const Worker& worker)
{
    int number = 0;
    const double begin = clocks().wall;
    worker.work(number++);
    std::cout << "ready " << clocks().wall - begin << std::endl;
    for (std::string line; std::getline(std::cin, line);) {
        const std::size_t space = line.find(' ');
        const std::string command = line.substr(0, space);
        const std::string argument = space == std::string::npos ? "" : line.substr(space + 1);
        if (command == "quit") break;
        if (command == "work") {
            std::ostringstream answer;
            answer.precision(9);
            answer << plainLoop() << ' ';
            for (int left = std::stoi(argument); left > 0; --left) {
                const Clocks before = clocks();
                worker.work(number++);
                const Clocks after = clocks();
                answer << after.wall - before.wall << ' ' << after.cpu - before.cpu << ' ';
            }
            std::cout << answer.str() << std::endl;
        } else if (command == "picture") {
            writePicture(worker, argument);
            std::cout << "written" << std::endl;
        } else if (command == "facts") {
            std::cout << '{' << (worker.facts ? worker.facts() : "") << '}' << std::endl;
        } else {
            throw std::runtime_error("'" + line +
                                     "' is no command; work N, picture PATH, facts and quit are");
        }
    }
    return 0;
}

int guarded(int argc, char** argv, const std::function<int(const std::vector<std::string>&)>& main)
{
    try {
        return main({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << argv[0] << ": " << error.what() << std::endl;
        return 1;
    }
}

std::string jsonPair(const std::string& name, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.9g", value);
    return '"' + name + "\": " + text;
}

std::string jsonPair(const std::string& name, const std::string& value)
{
    std::string text;
    for (const char c : value)
        if (c != '"' && c != '\\' && static_cast<unsigned char>(c) >= ' ') text += c;
    return '"' + name + "\": \"" + text + '"';
}

double turnOf(int number)
{
    return 0.01 * (number % 5 - 2);
}

} // namespace bench
