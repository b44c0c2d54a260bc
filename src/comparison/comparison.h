#pragma once

// A comparison in a folder: several runs at a time, each on one core and saved when it ends.

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

// Makes the back-end of one thread of a comparison, which uses one core of this machine.
using BackendMaking = std::function<Result<std::unique_ptr<EvaluationBackend>>()>;

// Returns the path of the creature file that a comparison in this folder writes for a finished run.
std::filesystem::path champion_file(const std::filesystem::path& folder, const ComparedRun& run);

class Comparison {
public:
    // Opens a folder, which is made if there is none. Runs that are already in its table, with the
    // same settings and simulator, are not repeated. Other rows of the table are kept.
    static Result<std::unique_ptr<Comparison>> open(const std::filesystem::path& folder,
                                                    std::vector<PlannedRun> runs,
                                                    const EvolutionKinds& kinds);

    // Runs what is missing, at most `at_a_time` runs at once. Each thread makes one back-end with
    // `make`. When a run ends, its row and its champion are written, then `told` is called with the
    // row, by one thread at a time. Fails at the first run that cannot be written, made or
    // continued. If stopped, unfinished runs are lost.
    Status run(std::size_t at_a_time, const BackendMaking& make,
               const std::function<void(const ComparedRun&)>& told, const std::stop_token& stop);

    // May be called while run() works.
    double share_done() const;
    std::size_t missing() const { return missing_.size(); }

    // Returns the finished runs of the plan, in its order.
    std::vector<ComparedRun> finished() const;

private:
    Comparison(std::filesystem::path folder, std::vector<PlannedRun> runs,
               std::vector<ComparedRun> table, const EvolutionKinds& kinds);
    // Performs one of the missing runs; makes its back-end if there is none yet.
    Result<std::optional<FinishedRun>> perform_missing(std::size_t index,
                                                       std::unique_ptr<EvaluationBackend>& backend,
                                                       const BackendMaking& make,
                                                       const std::stop_token& stop);
    Status keep(const FinishedRun& finished);

    std::filesystem::path folder_;
    std::vector<PlannedRun> runs_;
    std::vector<ComparedRun> table_;
    const EvolutionKinds* kinds_;
    // Indices of the runs that were missing when the comparison was opened.
    std::vector<std::size_t> missing_;
    std::atomic<std::uint64_t> done_ = 0;
    std::uint64_t planned_ = 0;  // trials of the missing runs
};

}  // namespace cambrian
