#include "studio/phenotype_cache.h"

namespace cambrian {
namespace {

constexpr std::size_t kMostEntries = 2000;
constexpr unsigned kUnusedFrames = 600;

}  // namespace

void PhenotypeCache::begin_frame(int most_grown) {
    may_grow_ = most_grown;
    ++frame_;
    if (entries_.size() > kMostEntries) forget_unused();
}

void PhenotypeCache::forget_unused() {
    std::erase_if(entries_,
                  [this](const auto& item) { return frame_ - item.second.used > kUnusedFrames; });
}

const Phenotype* PhenotypeCache::find(const GenomePtr& genome, const Kinds& kinds,
                                      const ExpressionSettings& expression,
                                      const SceneSettings& scene) {
    const auto known = entries_.find(genome.get());
    if (known != entries_.end()) {
        known->second.used = frame_;
        return known->second.phenotype.get();
    }
    if (may_grow_ <= 0) return nullptr;
    --may_grow_;
    Entry entry{genome,
                std::make_unique<const Phenotype>(express(*genome, kinds, expression, scene)),
                frame_};
    return entries_.emplace(genome.get(), std::move(entry)).first->second.phenotype.get();
}

}  // namespace cambrian
