#pragma once

#include "evolution/engine/snapshot.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// The starred creatures, each with the settings that evaluated it. They remain after their
// generation has passed.
class Stars {
public:
    // In the order in which the stars were given.
    const std::vector<JudgedIndividual>& all() const { return all_; }
    bool has(const Individual& individual) const;
    void toggle(const JudgedIndividual& creature);
    // Replaces the stars by those of another experiment.
    void replace(std::vector<JudgedIndividual> all);
    // Restores the star that was removed last, if there is one.
    void restore();
    bool can_restore() const { return !taken_.empty(); }
    std::uint64_t revision() const { return revision_; }  // number of changes so far

private:
    std::vector<JudgedIndividual> all_;
    std::vector<JudgedIndividual> taken_;  // removed stars, the last removed one at the end
    std::uint64_t revision_ = 0;
};

}  // namespace cambrian
