// A mouth: its part eats in a preserve what the diet allows. Its signal has no effect.

#include "organs/kinds.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr double kOmnivore = 0.5;
constexpr double kFarEnd = 1.0;  // half lengths from the middle

void eat(const OrganSite& /*site*/, double /*signal*/, Emissions& /*emissions*/) {}

std::string mouth_in_words(std::span<const double> parameters) {
    return fmt::format(
        "Eats in a preserve, with a diet of {:.2f}, where 0 means plants and 1 means flesh.",
        parameters[0]);
}

}  // namespace

void add_mouth_organ(OrganRegistry& organs) {
    organs.add({.id = "mouth",
                .label = "Mouth",
                .parameters = {{.name = "diet",
                                .key = "diet",
                                .fallback = kOmnivore,
                                .help = "What it digests: 0 means plants, 1 means flesh."}},
                .act = eat,
                .words = mouth_in_words,
                .place = kFarEnd,
                .mark = OrganMark::kMouth,
                .eats = true});
}

}  // namespace cambrian
