#include "studio/coach/founder_crowd.h"

#include "evolution/evaluation/trials.h"
#include "evolution/generation.h"
#include "pictures/scene/character.h"

#include <algorithm>

namespace cambrian {

void FounderCrowd::show(const SettingsPtr& settings) {
    settings_ = settings;
    founders_.clear();
    const auto count = std::min(kMostFounders, static_cast<std::size_t>(settings->population.size));
    std::vector<double> sizes;
    for (std::size_t slot = 0; slot < count; ++slot) {
        founders_.push_back(make_immigrant(*settings, kinds_, 0, slot));
        sizes.push_back(body_size(express(*founders_.back()->genome, kinds_.creature,
                                          settings->expression, settings->world.scene)));
    }
    std::sort(sizes.begin(), sizes.end());
    big_body_ = sizes[3 * sizes.size() / 4];
    motion_.show(founders_, settings->expression, first_trial_world(*settings));
}

}  // namespace cambrian
