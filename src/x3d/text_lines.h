#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace vo {

/// Whether a line ends here: LF, CR LF (at its LF), or CR alone.
inline bool endsLine(std::string_view text, std::size_t at)
{
    return text[at] == '\n' || (text[at] == '\r' && (at + 1 == text.size() || text[at + 1] != '\n'));
}

/// Which line a place in a text is on, counted from 1.
class TextLines
{
public:
    explicit TextLines(std::string_view text)
    {
        for (std::size_t at = 0; (at = text.find_first_of("\r\n", at)) != text.npos; ++at)
            if (endsLine(text, at)) ends_.push_back(at);
    }

    int lineAt(std::size_t place) const
    {
        return static_cast<int>(std::ranges::lower_bound(ends_, place) - ends_.begin()) + 1;
    }

private:
    std::vector<std::size_t> ends_;
};

} // namespace vo
