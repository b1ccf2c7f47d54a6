// Runs a fuzz target where libFuzzer is not: inputs are files of a folder, changed by chance that begins with
// the same number in every run.
//
//     TARGET FOLDER SECONDS [SEED]
//     TARGET FILE...           these inputs once, unchanged

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

constexpr std::size_t kLongest = 1 << 16;
constexpr unsigned kHangSeconds = 30;

std::string contentsOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class Mutator
{
public:
    Mutator(std::vector<std::string> inputs, unsigned seed) : inputs_(std::move(inputs)), random_(seed) {}

    std::string next()
    {
        std::string text = any(inputs_);
        for (std::size_t i = upTo(5); i-- > 0;)
            change(text);
        if (text.size() > kLongest) text.resize(kLongest);
        return text;
    }

private:
    std::size_t upTo(std::size_t most)
    {
        return std::uniform_int_distribution<std::size_t>(0, most)(random_);
    }
    const std::string& any(const std::vector<std::string>& list) { return list[upTo(list.size() - 1)]; }

    void change(std::string& text)
    {
        static const std::vector<std::string> kPieces{"\"",
                                                      "'",
                                                      "<",
                                                      ">",
                                                      "/>",
                                                      "{",
                                                      "}",
                                                      "[",
                                                      "]",
                                                      "&lt;",
                                                      "&#0;",
                                                      "&e;",
                                                      "#",
                                                      "\\",
                                                      "\n",
                                                      "\r\n",
                                                      "DEF ",
                                                      "USE ",
                                                      "NULL",
                                                      "TRUE",
                                                      "ROUTE ",
                                                      " TO ",
                                                      "-1",
                                                      "1e999",
                                                      "-1e-999",
                                                      "nan",
                                                      "0x7fffffff",
                                                      "4294967295",
                                                      "2147483648",
                                                      "99999999999999999999",
                                                      "DEF='A' ",
                                                      "USE='A' ",
                                                      "<Group>",
                                                      "</Group>",
                                                      "<!--",
                                                      "-->",
                                                      "<![CDATA[",
                                                      "\xff",
                                                      "\xef\xbb\xbf",
                                                      "<!DOCTYPE X3D [<!ENTITY e 'x'>]>",
                                                      "containerField='voxels' ",
                                                      "image='1 65536 65536 65536' ",
                                                      "PROTO P [] {}"};
        const std::size_t at = upTo(text.size());
        const std::size_t some = std::min(text.size() - at, upTo(40));
        switch (upTo(6)) {
        case 0: text.erase(at, some); break;
        case 1: text.insert(at, any(kPieces)); break;
        case 2: text.insert(upTo(text.size()), std::string(text, at, some)); break;
        case 3: text.resize(at); break;
        case 4:
            if (at < text.size()) text[at] = static_cast<char>(upTo(255));
            break;
        case 5: {
            const std::string& other = any(inputs_);
            text = text.substr(0, at) + other.substr(upTo(other.size()));
            break;
        }
        default: changeNumber(text, at);
        }
    }

    void changeNumber(std::string& text, std::size_t from)
    {
        const auto at = text.find_first_of("0123456789", from);
        if (at != text.npos) text.replace(at, 1, std::to_string(upTo(1) ? upTo(9) : random_()));
    }

    std::vector<std::string> inputs_;
    std::mt19937 random_;
};

/// What hangs or crashes lies in a file, to be run alone.
void run(const std::string& text)
{
    static const std::string kept =
        (std::filesystem::temp_directory_path() / ("fuzz-input-" + std::to_string(::getpid()))).string();
    std::ofstream(kept, std::ios::binary) << text;
    ::alarm(kHangSeconds);
    // A block of just this size: what reads past its end is noticed.
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
    ::alarm(0);
    std::filesystem::remove(kept);
}

} // namespace

int main(int argc, char** argv)
{
    namespace fs = std::filesystem;
    if (argc < 2 || !fs::is_directory(argv[1])) {
        for (int i = 1; i < argc; ++i)
            run(contentsOf(argv[i]));
        return 0;
    }
    std::vector<fs::path> paths(fs::directory_iterator(argv[1]), {});
    std::ranges::sort(paths);
    std::vector<std::string> inputs;
    for (const fs::path& path : paths)
        run(inputs.emplace_back(contentsOf(path)));
    if (inputs.empty()) {
        std::fprintf(stderr, "%s: no inputs\n", argv[1]);
        return 1;
    }
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::seconds(argc > 2 ? std::atoi(argv[2]) : 60);
    Mutator mutator(std::move(inputs), argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1);
    long runs = 0;
    for (; std::chrono::steady_clock::now() < end; ++runs)
        run(mutator.next());
    std::printf("%ld inputs\n", runs);
    return 0;
}
