#include "studio/widgets/phenotype_cache.h"

namespace cambrian {

void PhenotypeCache::begin_frame(int most_grown) {
    may_grow_ = most_grown;
}

void PhenotypeCache::clear() {
    entries_.clear();
    by_use_.clear();
}

void PhenotypeCache::forget_oldest() {
    const auto oldest = by_use_.begin();
    entries_.erase(oldest->second);
    by_use_.erase(oldest);
}

const Phenotype* PhenotypeCache::find(const GenomePtr& genome, const Kinds& kinds,
                                      const ExpressionSettings& expression,
                                      const SceneSettings& scene) {
    auto known = entries_.find(genome.get());
    if (known == entries_.end()) {
        if (may_grow_ <= 0) return nullptr;
        --may_grow_;
        if (entries_.size() == kMostKept) forget_oldest();
        auto grown = std::make_unique<const Phenotype>(express(*genome, kinds, expression, scene));
        known = entries_.emplace(genome.get(), Entry{genome, std::move(grown)}).first;
    }
    Entry& entry = known->second;
    by_use_.erase(entry.used);
    entry.used = ++uses_;
    by_use_.emplace(entry.used, genome.get());
    return entry.phenotype.get();
}

}  // namespace cambrian
