#include "style/style.h"

#include <algorithm>

namespace vo {

StyleChain effectiveChain(const StyleChain& chain)
{
    const auto last =
        std::find_if(chain.rbegin(), chain.rend(), [](const auto& style) { return style->replacesColor(); });
    return last == chain.rend() ? chain : StyleChain(last.base() - 1, chain.end());
}

} // namespace vo
