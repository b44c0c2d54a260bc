// A gland: leaves scent behind at the part's near end, at a rate that follows its signal.

#include "organs/kinds.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kNearEnd = -1.0;  // half lengths from the middle

void give_off_scent(const OrganSite& site, double signal, Emissions& emissions) {
    const double rate = std::clamp(signal, 0.0, 1.0);
    if (!(rate > 0.0)) return;
    emissions.scents.push_back({point_on_axis(site.scene, site.index, kNearEnd), rate * site.dt});
}

std::string scent_in_words(std::span<const double> /*parameters*/) {
    return "Leaves scent behind its near end while its signal is above 0.";
}

}  // namespace

void add_scent_organ(OrganRegistry& organs) {
    organs.add({.id = "scent",
                .label = "Scent gland",
                .act = give_off_scent,
                .words = scent_in_words,
                .place = kNearEnd,
                .mark = OrganMark::kDots,
                .scents = true});
}

}  // namespace cambrian
