#include "evolution/evaluation/pruning.h"

#include "breeding/disconnected_neurons.h"
#include "breeding/gene_sites.h"
#include "core/sample_statistics.h"
#include "evolution/evaluation/trials.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLeastKept = 0.997;  // share of the score
constexpr int kMostPasses = 4;

// A creature with one gene less.
struct Cut {
    std::string words;
    std::function<void(Genome&)> make;
};

// The last genes come first, so that those before them keep their place.
std::vector<Cut> cuts_of(const Genome& genome) {
    std::vector<Cut> cuts;
    for (const EdgeSite& site : edge_sites(genome))
        cuts.push_back({site.in_words(), [site](Genome& cut) {
                            std::vector<EdgeGene>& edges = cut.nodes[site.node].edges;
                            edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(site.edge));
                        }});
    for (const OrganGeneSite& site : organ_sites(genome))
        cuts.push_back({site.in_words(), [site](Genome& cut) {
                            std::vector<OrganGene>& organs = cut.nodes[site.node].organs;
                            organs.erase(organs.begin() + static_cast<std::ptrdiff_t>(site.organ));
                        }});
    Genome read = genome;
    for (const InputSite& site : input_sites(genome))
        if (site.in(read).source.kind != SourceKind::kConstant)
            cuts.push_back({site.in_words(),
                            [site](Genome& cut) { site.in(cut) = {.source = {}, .weight = 0.0}; }});
    std::reverse(cuts.begin(), cuts.end());
    return cuts;
}

class Pruner {
public:
    Pruner(const LesionStudy& study, const EvolutionKinds& kinds, EvaluationBackend& backend,
           EvaluationProgress& progress, const std::stop_token& stop)
        : study_(study),
          kinds_(kinds),
          probes_(lesion_probes(study.settings, study.worlds)),
          backend_(backend),
          progress_(progress),
          stop_(stop) {}

    std::optional<PrunedCreature> run() {
        const auto whole = score(study_.genome);
        if (!whole) return std::nullopt;
        PrunedCreature pruned{.genome = study_.genome, .removed = {}, .before = *whole};
        pruned.after = *whole;
        for (int pass = 0; pass < kMostPasses; ++pass) {
            const std::size_t before = pruned.removed.size();
            if (!run_pass(pruned)) return std::nullopt;
            if (pruned.removed.size() == before) break;
        }
        return pruned;
    }

private:
    // Tries each gene once, on what the others have left; false after a stop request.
    bool run_pass(PrunedCreature& pruned) {
        const std::vector<Cut> cuts = cuts_of(*pruned.genome);
        progress_.total = static_cast<std::uint32_t>(cuts.size());
        progress_.done = 0;
        Genome present = *pruned.genome;
        for (const Cut& cut : cuts) {
            Genome shorter = present;
            cut.make(shorter);
            const GenomePtr tried = tidied(shorter);
            const auto left = score(tried);
            if (!left) return false;
            ++progress_.done;
            if (*left < kLeastKept * pruned.before) continue;
            present = std::move(shorter);
            pruned.genome = tried;
            pruned.after = *left;
            pruned.removed.push_back(cut.words);
        }
        return true;
    }

    GenomePtr tidied(Genome genome) const {
        repair(genome, kinds_.creature.catalog);
        remove_disconnected_neurons(genome);
        return std::make_shared<const Genome>(std::move(genome));
    }

    std::optional<double> score(const GenomePtr& genome) {
        std::vector<EvaluationRequest> requests;
        for (const Probe& probe : probes_)
            requests.push_back(
                {.genome = genome, .trial_seed = trial_seed(study_.settings), .probe = probe});
        std::vector<std::optional<EvaluationResult>> results(requests.size());
        EvaluationProgress worlds;
        if (!backend_.evaluate(requests, results, study_.settings, worlds, stop_))
            return std::nullopt;
        std::vector<double> scores;
        for (const auto& result : results)
            scores.push_back(result->fitness);
        return median(scores);
    }

    const LesionStudy& study_;
    const EvolutionKinds& kinds_;
    std::vector<Probe> probes_;
    EvaluationBackend& backend_;
    EvaluationProgress& progress_;
    const std::stop_token& stop_;
};

}  // namespace

std::optional<PrunedCreature> pruned(const LesionStudy& study, const EvolutionKinds& kinds,
                                     EvaluationBackend& backend, EvaluationProgress& progress,
                                     const std::stop_token& stop) {
    return Pruner(study, kinds, backend, progress, stop).run();
}

}  // namespace cambrian
