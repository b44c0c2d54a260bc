#pragma once

// For how many injected creatures each generation of a journal has places. Further ones have no
// effect, so a damaged file cannot fill memory with them.

#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>

namespace cambrian {

class InjectionPlaces {
public:
    void begin(const ExperimentSettings& settings) {
        founders_ = static_cast<std::size_t>(settings.population.size);
        change(0, settings);
    }
    // Must be called in the order of the journal.
    void change(std::uint32_t generation, const ExperimentSettings& settings) {
        places_[generation] = static_cast<std::size_t>(settings.population.size);
    }
    std::size_t founders() const { return founders_; }
    // Returns whether one more injected creature has a place; the first place is always the
    // champion's.
    bool take(std::uint32_t generation) {
        if (generation != generation_) taken_ = 0;
        generation_ = generation;
        const auto after = places_.upper_bound(generation);
        return after != places_.begin() && ++taken_ < std::prev(after)->second;
    }

private:
    std::size_t founders_ = 0;
    std::map<std::uint32_t, std::size_t> places_;  // keyed by the first generation it holds for
    std::uint32_t generation_ = 0;
    std::size_t taken_ = 0;  // in that generation so far
};

}  // namespace cambrian
