#include "lookup_file.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace vo {
namespace {

constexpr std::size_t kFewestEntries = 2;
constexpr std::size_t kMostEntries = 4096;
constexpr std::uintmax_t kLargestFile = 16 << 20;

/// A number of a table, from 0 to 1 however it was written.
struct Number
{
    float value = 0;
    bool isDecimal = false;
};

/// A word of the file as it may be shown in a message.
std::string shown(const std::string& word)
{
    std::string result = "\"";
    for (const char letter : word.substr(0, 24))
        result += letter >= ' ' && letter <= '~' ? letter : '?';
    result += word.size() > 24 ? "...\"" : "\"";
    return result;
}

Result<Number> parsedNumber(const std::string& word)
{
    const char* const end = word.data() + word.size();
    const bool isDecimal = word.find('.') != std::string::npos;
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    const bool isWhole = word.find_first_not_of("-0123456789") == std::string::npos;
    if (error != std::errc() || stop != end || !(isDecimal || isWhole))
        return Failure{"expected a number, found " + shown(word)};
    if (!(value >= 0 && value <= (isDecimal ? 1 : 255)))
        return Failure{(isDecimal ? "expected a number with a decimal point from 0.0 to 1.0, found "
                                  : "expected a whole number from 0 to 255, found ") +
                       shown(word)};
    return Number{static_cast<float>(isDecimal ? value : value / 255), isDecimal};
}

std::vector<std::string> wordsOf(std::string line)
{
    line.resize(std::min(line.find('#'), line.size()));
    std::vector<std::string> words;
    constexpr const char* kBlanks = " \t\r\v\f";
    for (std::size_t from = line.find_first_not_of(kBlanks); from != std::string::npos;) {
        const std::size_t to = std::min(line.find_first_of(kBlanks, from), line.size());
        words.push_back(line.substr(from, to - from));
        from = line.find_first_not_of(kBlanks, to);
    }
    return words;
}

/// The entries so far, and what the first of them fixed for all.
struct Entries
{
    std::vector<std::array<float, 4>> rgba;
    std::size_t columns = 0;
    std::optional<bool> areDecimal;

    Result<void> add(const std::vector<std::string>& words);
};

Result<void> Entries::add(const std::vector<std::string>& words)
{
    if (words.size() != 2 && words.size() != 4)
        return Failure{"expected 2 numbers (luminance alpha) or 4 (red green blue alpha), found " +
                       std::to_string(words.size())};
    if (columns == 0) columns = words.size();
    if (words.size() != columns)
        return Failure{"expected " + std::to_string(columns) + " numbers as on the lines before, found " +
                       std::to_string(words.size())};
    if (rgba.size() == kMostEntries)
        return Failure{"expected at most " + std::to_string(kMostEntries) + " entries, found more"};
    std::array<float, 4> numbers{};
    for (std::size_t i = 0; i < columns; ++i) {
        const auto number = parsedNumber(words[i]);
        if (!number) return number.failure();
        if (!areDecimal) areDecimal = number->isDecimal;
        if (*areDecimal != number->isDecimal)
            return Failure{std::string("expected ") +
                           (*areDecimal ? "numbers with a decimal point" : "whole numbers") +
                           " as before, found " + shown(words[i])};
        numbers[i] = number->value;
    }
    rgba.push_back(columns == 4 ? numbers : std::array{numbers[0], numbers[0], numbers[0], numbers[1]});
    return {};
}

/// Keeps devices and files that are no tables from being read at all.
Result<void> checkFile(const std::string& path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        return Failure{path + ": expected a lookup table, found " +
                       (std::filesystem::is_directory(status) ? "a folder" : "a device or the like")};
    const auto size = std::filesystem::file_size(path, error);
    if (!error && size > kLargestFile)
        return Failure{path + ": expected a lookup table of at most " + std::to_string(kLargestFile) +
                       " bytes, found " + std::to_string(size)};
    return {};
}

LookupFile resampled(const Entries& entries)
{
    LookupFile table;
    table.isColor = entries.columns == 4;
    const auto last = entries.rgba.size() - 1;
    for (std::size_t i = 0; i < LookupFile::kEntries; ++i) {
        const double place = double(i * last) / (LookupFile::kEntries - 1);
        const auto below = std::min(static_cast<std::size_t>(place), last - 1);
        for (std::size_t channel = 0; channel < 4; ++channel)
            table.rgba[4 * i + channel] = static_cast<float>(
                std::lerp(double(entries.rgba[below][channel]), double(entries.rgba[below + 1][channel]),
                          place - double(below)));
    }
    return table;
}

} // namespace

Result<LookupFile> readLookupFile(const std::string& path)
{
    if (auto checked = checkFile(path); !checked) return checked.failure();
    std::ifstream file(path, std::ios::binary);
    if (!file) return Failure{path + ": cannot open: " + std::strerror(errno)};

    Entries entries;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        // Some editors begin a text in UTF-8 with a byte order mark.
        if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.erase(0, 3);
        const auto words = wordsOf(line);
        if (words.empty()) continue;
        if (auto added = entries.add(words); !added)
            return Failure{path + ": line " + std::to_string(number) + ": " + added.failure().text};
    }
    if (entries.rgba.size() < kFewestEntries)
        return Failure{path + ": expected a lookup table of 2 to 4096 entries, found " +
                       std::to_string(entries.rgba.size())};
    return resampled(entries);
}

} // namespace vo
