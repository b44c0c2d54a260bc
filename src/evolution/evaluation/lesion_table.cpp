#include "evolution/evaluation/lesion_table.h"

#include "core/sample_statistics.h"
#include "evolution/evaluation/sense_losses.h"
#include "evolution/evaluation/trials.h"

#include <algorithm>
#include <map>
#include <utility>

namespace cambrian {
namespace {

using Cases = std::vector<std::vector<Lesion>>;

class Laboratory {
public:
    Laboratory(const LesionStudy& study, EvaluationBackend& backend, EvaluationProgress& progress,
               const std::stop_token& stop)
        : study_(study),
          probes_(lesion_probes(study.settings, study.worlds)),
          backend_(backend),
          progress_(progress),
          stop_(stop) {}

    // Measures each case; returns nothing after a stop request.
    std::optional<std::vector<LesionRow>> measure(const Cases& cases) {
        std::vector<EvaluationRequest> requests;
        for (const std::vector<Lesion>& lesions : cases)
            for (const Probe& probe : probes_)
                requests.push_back({.genome = study_.genome,
                                    .trial_seed = trial_seed(study_.settings),
                                    .probe = probe,
                                    .lesions = lesions});
        std::vector<std::optional<EvaluationResult>> results(requests.size());
        if (!backend_.evaluate(requests, results, study_.settings, progress_, stop_))
            return std::nullopt;
        std::vector<LesionRow> rows;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            LesionRow row{.lesions = cases[i], .scores = {}};
            for (std::size_t world = 0; world < probes_.size(); ++world)
                row.scores.push_back(results[i * probes_.size() + world]->fitness);
            row.left = median(row.scores);
            rows.push_back(std::move(row));
        }
        return rows;
    }

private:
    const LesionStudy& study_;
    std::vector<Probe> probes_;
    EvaluationBackend& backend_;
    EvaluationProgress& progress_;
    const std::stop_token& stop_;
};

// Returns the intact creature, each lesion and, of each sensor, all constants other than silence.
Cases cases_of(const std::shared_ptr<const Phenotype>& body, const LesionStudy& study,
               const EvolutionKinds& kinds, const std::stop_token& stop) {
    Cases cases = {{}};
    for (const Lesion& lesion : lesions_of(*body))
        cases.push_back({lesion});
    const std::vector<SenseConstants> constants =
        sense_constants(body, study.settings, kinds, stop);
    for (std::uint32_t i = 0; i < constants.size(); ++i)
        for (const double constant : constants[i])
            if (constant != 0.0) cases.push_back({{LesionKind::kHeldSensor, i, 0, constant}});
    return cases;
}

bool holds_constant(const LesionRow& row) {
    return row.lesions.front().constant != 0.0;
}

// Keeps, of the constants of a sensor, only the best one, if it leaves more than silence.
void keep_best_constants(std::vector<LesionRow>& rows) {
    std::map<std::uint32_t, double> best;
    for (const LesionRow& row : rows) {
        if (row.lesions.front().kind != LesionKind::kHeldSensor) continue;
        const auto [place, first] = best.emplace(row.lesions.front().index, row.left);
        if (!first) place->second = std::max(place->second, row.left);
    }
    for (const LesionRow& row : rows)
        if (row.lesions.front().kind == LesionKind::kHeldSensor && !holds_constant(row) &&
            row.left >= best.at(row.lesions.front().index))
            best.erase(row.lesions.front().index);
    std::erase_if(rows, [&](const LesionRow& row) {
        if (!holds_constant(row)) return false;
        const auto found = best.find(row.lesions.front().index);
        if (found == best.end() || row.left < found->second) return true;
        best.erase(found);
        return false;
    });
}

void put_worst_first(std::vector<LesionRow>& rows) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const LesionRow& a, const LesionRow& b) { return a.left < b.left; });
}

Cases pairs_of(const std::vector<LesionRow>& rows) {
    const std::size_t count = std::min(rows.size(), kPairedLesions);
    Cases pairs;
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < count; ++b)
            pairs.push_back({rows[a].lesions.front(), rows[b].lesions.front()});
    return pairs;
}

}  // namespace

std::vector<Probe> lesion_probes(const ExperimentSettings& settings, int worlds) {
    std::vector<Probe> probes = probes_of(settings, 0, worlds);
    for (Probe& probe : probes)
        probe.finer = false;
    return probes;
}

std::optional<LesionTable> lesion_table(const LesionStudy& study, const EvolutionKinds& kinds,
                                        EvaluationBackend& backend, EvaluationProgress& progress,
                                        const std::stop_token& stop) {
    const auto body = grow(*study.genome, study.settings, kinds);
    Laboratory laboratory(study, backend, progress, stop);
    auto rows = laboratory.measure(cases_of(body, study, kinds, stop));
    if (!rows) return std::nullopt;
    LesionTable table{.intact = rows->front(), .rows = {}, .pairs = {}};
    rows->erase(rows->begin());
    keep_best_constants(*rows);
    put_worst_first(*rows);
    table.rows = *std::move(rows);
    if (!study.pairs) return table;
    auto pairs = laboratory.measure(pairs_of(table.rows));
    if (!pairs) return std::nullopt;
    put_worst_first(*pairs);
    table.pairs = *std::move(pairs);
    return table;
}

}  // namespace cambrian
