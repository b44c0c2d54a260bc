#pragma once

// A comparison under way in a folder: runs side by side, one a core, each kept as it ends.

#include "comparison/compared_run.h"
#include "core/result.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace cambrian {

// What a thread of a comparison evaluates with, on one core of its own besides any elsewhere.
using BackendMaking = std::function<Result<std::unique_ptr<EvaluationBackend>>()>;

class Comparison {
public:
    // In a folder that is there. Runs that its table has already, of the same settings and
    // simulator, are not run again; others of the table are kept as they are.
    static Result<std::unique_ptr<Comparison>> open(const std::filesystem::path& folder,
                                                    std::vector<PlannedRun> runs,
                                                    const EvolutionKinds& kinds);

    // Runs what is missing, so many at a time, writing the table and the champion of each as it
    // ends and then calling `told` with it, one at a time. Each of the threads that run makes
    // itself one back-end with `make`. Fails at the first that cannot be written, made or gone on
    // with. When stopped, runs under way are lost.
    Status run(std::size_t at_a_time, const BackendMaking& make,
               const std::function<void(const ComparedRun&)>& told, const std::stop_token& stop);

    // May be asked while it runs.
    double share_done() const;
    std::size_t missing() const { return missing_.size(); }

    // Those of the plan that have finished, in its order.
    std::vector<ComparedRun> finished() const;

private:
    Comparison(std::filesystem::path folder, std::vector<PlannedRun> runs,
               std::vector<ComparedRun> table, const EvolutionKinds& kinds);
    // One of the missing runs, with a back-end that is made if there is none yet.
    Result<std::optional<FinishedRun>> perform_missing(std::size_t index,
                                                       std::unique_ptr<EvaluationBackend>& backend,
                                                       const BackendMaking& make,
                                                       const std::stop_token& stop);
    Status keep(const PlannedRun& run, const FinishedRun& finished);

    std::filesystem::path folder_;
    std::vector<PlannedRun> runs_;
    std::vector<ComparedRun> table_;
    const EvolutionKinds* kinds_;
    std::vector<std::size_t> missing_;  // runs to do when opened
    std::atomic<std::uint64_t> done_ = 0;
    std::uint64_t planned_ = 0;  // trials of these
};

}  // namespace cambrian
