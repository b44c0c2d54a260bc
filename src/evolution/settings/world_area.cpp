#include "evolution/settings/world_area.h"

#include "core/text/number_text.h"

#include <fmt/core.h>

namespace cambrian {

std::string size_text(const WorldArea& area) {
    return fmt::format("{} m x {} m{}", short_text(area.width), short_text(area.height),
                       area.has_ground ? " above the ground" : "");
}

}  // namespace cambrian
