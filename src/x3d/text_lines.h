#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace vo {

/// Which line a place in a text is on, counted from 1.
class TextLines
{
public:
    explicit TextLines(std::string_view text)
    {
        for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; ++at)
            ends_.push_back(at);
    }

    int lineAt(std::size_t place) const
    {
        return static_cast<int>(std::ranges::lower_bound(ends_, place) - ends_.begin()) + 1;
    }

private:
    std::vector<std::size_t> ends_;
};

} // namespace vo
