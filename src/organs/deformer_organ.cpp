// A muscle of the part itself: it lengthens and narrows the part, or shortens and widens it,
// without changing its area (planar/README.md 20). Its motor follows the signal as that of a
// joint does.

#include "organs/kinds.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// The strength is the muscle's stress times the area that it works on.
void make_deformable(std::span<const double> parameters, const SceneSettings& settings,
                     PlannedPart& part) {
    const double area = 4.0 * part.half_extents.x() * part.half_extents.y();
    part.stretch = PlannedStretch{.low = parameters[0],
                                  .high = parameters[1],
                                  .max_effort = settings.muscle_strength * area,
                                  .rate_limit = settings.deform_speed_limit};
}

void deform(const OrganSite& site, double signal, Emissions& /*emissions*/) {
    if (!site.part.stretch) return;
    const double target = std::clamp(signal, site.part.stretch->low, site.part.stretch->high);
    site.memory += (target - site.memory) * site.smoothing_share;
    site.scene.set_stretch_target(site.index, site.memory);
}

std::string deform_in_words(std::span<const double> parameters) {
    const auto percent = [](double stretch) { return std::lround(100.0 * std::exp(stretch)); };
    return fmt::format(
        "Stretches its part to {} % of its length while its signal is above 0, and shortens it to "
        "{} % below.",
        percent(parameters[1]), percent(parameters[0]));
}

}  // namespace

void add_deformer_organ(OrganRegistry& organs) {
    organs.add({.id = "deformer",
                .label = "Deformer",
                .parameters = {{.name = "shortest",
                                .key = "low",
                                .low = -0.5,
                                .high = -0.05,
                                .fallback = -0.3,
                                .help = "Natural logarithm of the least length as a share of that "
                                        "at rest."},
                               {.name = "longest",
                                .key = "high",
                                .low = 0.05,
                                .high = 0.5,
                                .fallback = 0.3,
                                .help = "Natural logarithm of the greatest length as a share of "
                                        "that at rest."}},
                .act = deform,
                .words = deform_in_words,
                .mark = OrganMark::kArrows,
                .shape = make_deformable});
}

}  // namespace cambrian
