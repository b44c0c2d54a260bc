#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace cambrian::bench {

// Returns the kinds with the given ids; all if there are no ids.
template <class Kind>
std::vector<Kind> select_kinds(std::vector<Kind> kinds, const std::vector<std::string>& ids) {
    if (ids.empty()) return kinds;
    std::erase_if(kinds, [&](const Kind& kind) {
        return std::find(ids.begin(), ids.end(), kind.id) == ids.end();
    });
    return kinds;
}

}  // namespace cambrian::bench
