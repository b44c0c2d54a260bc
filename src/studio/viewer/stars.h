#pragma once

#include "evolution/snapshot.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// Creatures a person keeps, each with the settings that judged it: they stay when their generation
// has passed.
class Stars {
public:
    // In the order in which they were given.
    const std::vector<ChampionRecord>& all() const { return all_; }
    bool has(const Individual& individual) const;
    void toggle(const ChampionRecord& creature);
    // Those of another experiment.
    void replace(std::vector<ChampionRecord> all);
    // Gives back the star that was taken away last, if any was.
    void restore();
    bool can_restore() const { return !taken_.empty(); }
    std::uint64_t revision() const { return revision_; }  // counts changes

private:
    std::vector<ChampionRecord> all_;
    std::vector<ChampionRecord> taken_;  // last one last
    std::uint64_t revision_ = 0;
};

}  // namespace cambrian
