#pragma once

#include "core/text/pretty_text.h"

#include <fmt/core.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace cambrian {

// Returns a score with three decimals, so that scores in a column compare at a glance: "0.081
// BL/s".
inline std::string shown_score(double value, const std::string& unit) {
    if (!std::isfinite(value)) return "–";
    const std::string size = fmt::format("{:.3f}", std::fabs(value));
    std::string text = size;
    for (std::size_t end = size.find('.'); end > 3; end -= 3)
        text.insert(end - 3, " ");
    if (value < 0.0 && size != "0.000") text.insert(0, "−");
    const std::string pretty = pretty_unit(unit);
    return pretty.empty() ? text : text + " " + pretty;
}

}  // namespace cambrian
