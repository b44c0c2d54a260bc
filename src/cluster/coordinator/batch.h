#pragma once

// One call of EvaluationBackend::evaluate over a cluster: published units, answers and their
// certainty (cluster/README.md 1). It is not thread-safe. The caller gives the time, in seconds.

#include "cluster/coordinator/answers.h"
#include "cluster/coordinator/fading_ratio.h"
#include "cluster/coordinator/running_quantile.h"
#include "cluster/coordinator/trust.h"
#include "cluster/coordinator/unit_ledger.h"
#include "cluster/coordinator/unit_sizing.h"
#include "cluster/messages/result_text.h"
#include "evolution/evaluation/backend_status.h"
#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

class Batch {
public:
    static constexpr double kNoScore = -std::numeric_limits<double>::infinity();
    // Data that outlives a batch.
    struct Memory {
        CostModel costs = {};
        Trust trust;
        // The turnaround of units as a multiple of what their work explains, and beyond it in s:
        // workers may be slow or busy with the units of other runs.
        RunningQuantile patience{1.0, 100.0};
        RunningQuantile latency{1e-3, 10.0};
        // The time of this machine's cores, which runs at once share, over their processor time.
        FadingRatio own_pace{50.0};
        double last_best = kNoScore;  // fitness in the last batch
        BackendCounts counts = {};
        std::vector<std::uint64_t> other_bits = {};  // workers refused since a result differed
    };
    // The requests in the order of publication; their slots become their places in it.
    Batch(std::vector<EvaluationRequest> requests, std::uint32_t generation, Memory& memory);

    const std::vector<EvaluationRequest>& requests() const { return requests_; }
    std::vector<EvaluationRequest> requests_of(const std::vector<std::size_t>& creatures) const;
    std::uint32_t generation() const { return generation_; }

    struct HomeTask {
        std::vector<std::size_t> creatures;
        bool late = false;  // of a late unit, which may have crashed its worker
        // Workers that have sent nothing since this time may have vanished.
        std::optional<double> silent_since = std::nullopt;
    };
    // Returns the next task of a core of this machine; nothing while it must wait.
    std::optional<HomeTask> next_home_task(double now, const Cores& cores);
    std::optional<double> next_due() const { return ledger_.next_due(); }
    // The time that a computation took, s; 0 if unknown.
    struct Took {
        double processor = 0.0;
        double wall = 0.0;
    };
    void finish_at_home(std::size_t creature, EvaluationResult result, const Took& took);

    struct UnitPlan {
        std::uint32_t number = 0;
        std::vector<std::size_t> creatures;
        double seconds = 0.0;  // expected, of one core
    };
    // Returns the next unit to publish, which then counts as published; none if enough units are
    // outstanding.
    std::optional<UnitPlan> next_unit(double now, const Cores& cores);
    void not_published(std::uint32_t unit);
    // Limits the following units to fewer creatures than this.
    void too_large(const UnitPlan& plan);
    // Abandons a unit that no worker will answer.
    void not_deliverable(std::uint32_t unit) { ledger_.expect_no_more(unit); }
    bool anything_outstanding() const { return ledger_.outstanding() > 0; }

    // The part of a result that counted. Each worker counts once for a creature.
    struct Taken {
        std::size_t creatures = 0;
        std::uint64_t work = 0;  // EvaluationResult::work of them
    };
    // Returns nothing if the result is no answer to this batch. Once the batch is complete, answers
    // are counted and dropped.
    std::optional<Taken> take_result(std::uint32_t unit, const UnitResult& result, double now,
                                     const Cores& cores);

    std::size_t settled() const { return answers_.settled(); }
    // Whether every creature has a result that counts, and the best is certain. A complete batch
    // stays complete.
    bool complete();
    const EvaluationResult* result(std::size_t creature) const { return answers_.result(creature); }
    double core_seconds() const { return core_seconds_; }  // time that its results took

private:
    std::optional<HomeTask> check_task();
    bool is_answer(const UnitResult& result) const;
    // Returns whether it counted.
    bool take_claim(const UnitResult& unit, const SlotResult& each, double least);
    void compare(const ResultComparison& comparison);
    void refuse(std::uint64_t worker);
    // Closes an answered unit and learns from its turnaround.
    std::vector<std::size_t> close(std::uint32_t unit, double now);

    std::vector<EvaluationRequest> requests_;
    std::uint32_t generation_;
    Memory& memory_;
    UnitLedger ledger_;
    Answers answers_;
    struct Published {
        double at = 0.0;
        double expected = 0.0;  // turnaround by work alone, s
    };
    std::vector<Published> published_;  // by unit
    std::size_t most_creatures_;
    double best_ = kNoScore;  // fitness of any result so far
    double core_seconds_ = 0.0;
    bool complete_ = false;
};

}  // namespace cambrian
