#pragma once

#include "creature/phenotype.h"

#include <map>
#include <memory>

namespace cambrian {

// Bodies of creatures that are shown small, grown when first needed, a few a frame.
class PhenotypeCache {
public:
    // At most so many are grown until the next begin_frame().
    void begin_frame(int most_grown);
    // Null if its turn has not come yet.
    const Phenotype* find(const GenomePtr& genome, const Kinds& kinds,
                          const ExpressionSettings& expression, const SceneSettings& scene);
    void clear() { entries_.clear(); }

private:
    struct Entry {
        GenomePtr genome;  // keeps the key's address from being used again
        std::unique_ptr<const Phenotype> phenotype;
        unsigned used = 0;  // frame
    };
    void forget_unused();

    std::map<const Genome*, Entry> entries_;
    int may_grow_ = 0;
    unsigned frame_ = 0;
};

}  // namespace cambrian
