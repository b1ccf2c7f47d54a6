#pragma once

#include <cstring>
#include <map>
#include <set>
#include <string>

#include "x3d/scene.h"

namespace vo {

/// Compares two scenes node by node: which are set, to which bits, which stand in several places, names and
/// routes.
class GraphComparison
{
public:
    /// Where they differ first; "" where they do not.
    std::string difference(const Scene& a, const Scene& b)
    {
        if (a.edition != b.edition) return "editions";
        if (a.header.profile != b.header.profile || a.header.version != b.header.version) return "headers";
        if (!same(a.roots, b.roots, "roots")) return where_;
        return sameRoutes(a, b) ? "" : "routes";
    }

private:
    bool differ(const std::string& where)
    {
        where_ = where;
        return false;
    }

    bool same(const std::vector<Node*>& a, const std::vector<Node*>& b, const std::string& where)
    {
        if (a.size() != b.size()) return differ(where + ": number of nodes");
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!same(*a[i], *b[i], where + "." + std::to_string(i))) return false;
        return true;
    }

    bool same(const Node& a, const Node& b, const std::string& where)
    {
        const auto [pair, isNew] = partner_.emplace(&a, &b);
        if (!isNew) return pair->second == &b || differ(where + ": another node");
        if (!partners_.insert(&b).second) return differ(where + ": a shared node");
        if (&a.type() != &b.type() || a.edition() != b.edition()) return differ(where + ": type or edition");
        // Writers name what stands in several places.
        if (!a.name.empty() && a.name != b.name) return differ(where + ": name " + a.name);
        if (a.settings().size() != b.settings().size()) return differ(where + ": number of fields");
        for (std::size_t i = 0; i < a.settings().size(); ++i) {
            const auto &x = a.settings()[i], &y = b.settings()[i];
            const std::string field = where + "." + a.field(x.slot).name;
            if (x.slot != y.slot || x.value.index() != y.value.index()) return differ(field);
            if (const auto* const nodes = std::get_if<std::vector<Node*>>(&x.value)) {
                if (!same(*nodes, std::get<std::vector<Node*>>(y.value), field)) return false;
            } else if (x.value != y.value) {
                return differ(field + ": value");
            }
        }
        return true;
    }

    bool sameRoutes(const Scene& a, const Scene& b)
    {
        if (a.routes.size() != b.routes.size()) return false;
        for (std::size_t i = 0; i < a.routes.size(); ++i) {
            const Route &x = a.routes[i], &y = b.routes[i];
            if (x.fromSlot != y.fromSlot || x.toSlot != y.toSlot || partner_[x.from] != y.from ||
                partner_[x.to] != y.to)
                return false;
        }
        return true;
    }

    std::map<const Node*, const Node*> partner_;
    std::set<const Node*> partners_;
    std::string where_;
};

inline std::string graphDifference(const Scene& a, const Scene& b)
{
    return GraphComparison().difference(a, b);
}

} // namespace vo
