#include "evolution/settings/light_patches.h"

#include "core/text/number_rows.h"
#include "core/text/number_text.h"

#include <fmt/core.h>

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

Status check_patch(const LightPatch& patch, const WorldArea& area) {
    if (!area.contains(patch.center))
        return Error{"its middle is outside the world, which has " + size_text(area)};
    if (patch.spread >= kLeastSpread && patch.spread <= kMostSpread) return {};
    return Error{fmt::format("its spread is {} m; expected {} m to {} m", short_text(patch.spread),
                             short_text(kLeastSpread), short_text(kMostSpread))};
}

}  // namespace cambrian
