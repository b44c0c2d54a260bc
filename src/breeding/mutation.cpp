#include "breeding/mutation.h"

#include "breeding/disconnected_neurons.h"
#include "core/assert.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr int kTries = 30;          // attempts of one operator to change the genome
constexpr double kHueStep = 0.004;  // change of the display hue per mutation, in turns

// Draws operators by weight and applies them in the order of their phases.
class Mutating {
public:
    Mutating(Genome& genome, const MutationSettings& settings, const MutationRegistry& kinds,
             const MutationContext& context, RandomStream& stream)
        : genome_(genome),
          kinds_(kinds),
          context_(context),
          stream_(stream),
          first_hash_(genome_hash(genome)),
          hash_(first_hash_) {
        for (const MutationKind& kind : kinds.all())
            weights_.push_back(weight_of(kind, settings));
    }

    std::vector<MutationRecord> run(int count) {
        for (; count > 0; --count)
            draw_operator(MutationPhase::kParameters);
        while (!pending_.empty())
            apply_next();
        return std::move(records_);
    }

private:
    double weight_of(const MutationKind& kind, const MutationSettings& settings) const {
        if (kind.enabled != nullptr && !kind.enabled(context_)) return 0.0;
        const auto named = settings.weights.find(kind.id);
        return named == settings.weights.end() ? kind.default_weight
                                               : std::fmax(named->second, 0.0);
    }

    // Operators are applied by phase, and within a phase in the order of the registry.
    bool applies_before(std::size_t a, std::size_t b) const {
        return std::pair(kinds_[a].phase, a) < std::pair(kinds_[b].phase, b);
    }

    // Draws an operator of the given phase or a later one; if none of these is enabled, any
    // operator.
    void draw_operator(MutationPhase earliest) {
        std::vector<double> weights = weights_;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            if (kinds_[i].phase < earliest) weights[i] = 0.0;
        }
        if (none_enabled(weights)) weights = weights_;
        if (none_enabled(weights)) return;
        const std::size_t drawn = stream_.weighted(weights);
        const auto place =
            std::upper_bound(pending_.begin(), pending_.end(), drawn,
                             [&](std::size_t a, std::size_t b) { return applies_before(a, b); });
        pending_.insert(place, drawn);
    }

    static bool none_enabled(const std::vector<double>& weights) {
        return std::none_of(weights.begin(), weights.end(),
                            [](double weight) { return weight > 0.0; });
    }

    // If an operator cannot change the genome, another one is drawn in its place.
    void apply_next() {
        CAMBRIAN_TICK_ASSERT(!pending_.empty(), "an operator waits");
        const std::size_t next = pending_.front();
        pending_.erase(pending_.begin());
        for (int i = 0; i < kTries; ++i) {
            if (try_apply(kinds_[next])) return;
        }
        weights_[next] = 0.0;
        draw_operator(kinds_[next].phase);
    }

    // A mutation counts if it changes the genome and does not merely undo earlier ones.
    bool try_apply(const MutationKind& kind) {
        MutationRecord record;
        record.operator_id = kind.id;
        Genome mutated = genome_;
        if (!kind.apply(mutated, context_, stream_, record)) return false;
        repair(mutated, context_.catalog);
        CAMBRIAN_TICK_ASSERT(validate(mutated, context_.catalog).empty(),
                             "a mutation leaves a valid genome");
        const std::uint64_t hash = genome_hash(mutated);
        if (hash == hash_ || hash == first_hash_) return false;
        genome_ = std::move(mutated);
        hash_ = hash;
        records_.push_back(std::move(record));
        return true;
    }

    Genome& genome_;
    const MutationRegistry& kinds_;
    const MutationContext& context_;
    RandomStream& stream_;
    std::uint64_t first_hash_;
    std::uint64_t hash_;                // of the present genome
    std::vector<double> weights_;       // of each operator; 0 if it cannot be applied
    std::vector<std::size_t> pending_;  // operators in the order of application
    std::vector<MutationRecord> records_;
};

}  // namespace

std::vector<MutationRecord> mutate(Genome& genome, const MutationSettings& settings,
                                   const MutationRegistry& kinds, const MutationContext& context,
                                   RandomStream& stream, int extra) {
    CAMBRIAN_ASSERT(!genome.nodes.empty(), "only valid genomes are mutated");
    CAMBRIAN_TICK_ASSERT(extra >= 0, "mutations are added");
    const int count = draw_mutation_count(settings, stream) + extra;
    auto records = Mutating(genome, settings, kinds, context, stream).run(count);
    if (settings.remove_disconnected_neurons) remove_disconnected_neurons(genome);
    const double hue = genome.hue + kHueStep * static_cast<double>(records.size());
    genome.hue = hue - std::floor(hue);
    CAMBRIAN_TICK_ASSERT(genome.hue >= 0.0 && genome.hue <= 1.0, "a hue");
    return records;
}

}  // namespace cambrian
