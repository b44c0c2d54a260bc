#include "evolution/settings/light_patches.h"

#include "core/text/number_text.h"
#include "evolution/settings/number_rows.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {

Result<std::vector<LightPatch>> patches_of(std::string_view text) {
    const auto rows = number_rows(text, {3, kMostPatches, "patch",
                                         "\"x y spread; ...\", the middle of each and "
                                         "its standard deviation in m"});
    if (!rows) return rows.error();
    std::vector<LightPatch> patches;
    for (const std::vector<double>& row : *rows)
        patches.push_back({{row[0], row[1], 0.0}, row[2]});
    return patches;
}

Status check_patch(const LightPatch& patch, double width, double height) {
    if (std::fabs(patch.center.x()) > 0.5 * width || std::fabs(patch.center.y()) > 0.5 * height) {
        return Error{fmt::format("its middle is outside the world, which has {} m x {} m",
                                 short_text(width), short_text(height))};
    }
    if (patch.spread >= kLeastSpread && patch.spread <= kMostSpread) return {};
    return Error{fmt::format("its spread is {} m; expected {} m to {} m", short_text(patch.spread),
                             short_text(kLeastSpread), short_text(kMostSpread))};
}

}  // namespace cambrian
