#pragma once

// The answers of a batch: the worker that gave each, and whether it is certain. Results of this
// machine's cores are the reference for those of workers; results of two workers are compared with
// each other.

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

// The comparison of a worker's result with that of this machine.
struct ResultComparison {
    std::uint64_t worker = 0;
    bool equal = false;  // every bit
};

class Answers {
public:
    explicit Answers(std::size_t creatures) : answers_(creatures) {}

    // Whether an answer of that worker still counts for the creature: its first one does, unless
    // many others have answered.
    bool hears(std::size_t creature, std::uint64_t worker) const;
    // Adds a worker's result, which hears() accepts. With `check`, it does not count until this
    // machine has computed it, too.
    struct Claimed {
        bool first = false;  // of this creature
        std::optional<ResultComparison> comparison;
    };
    Claimed claim(std::size_t creature, std::uint64_t worker, EvaluationResult result, bool check);
    // Adds the result of this machine; returns its comparison with each claim.
    std::vector<ResultComparison> compute(std::size_t creature, EvaluationResult result);
    // Revokes results that no other worker claims too. Returns the creatures that lost theirs.
    std::vector<std::size_t> drop_worker(std::uint64_t worker);

    // Whether the creature has an answer, certain or not.
    bool claimed(std::size_t creature) const {
        return answers_[creature].home || !answers_[creature].claims.empty();
    }
    // Whether the creature has a result that counts.
    bool settled(std::size_t creature) const;
    std::size_t settled() const { return settled_; }
    bool all_settled() const { return settled_ == answers_.size(); }
    // Returns the result that counts; null unless settled.
    const EvaluationResult* result(std::size_t creature) const;

    // The next creature that this machine must compute as a check; each is returned once.
    std::optional<std::size_t> next_check();
    // Requests the check of the best creature that has an answer, unless it is certain. Returns
    // whether that check is still to come.
    bool check_leader();

private:
    struct Claim {
        std::uint64_t worker = 0;
        EvaluationResult result;
    };
    struct Answer {
        std::vector<Claim> claims;
        std::optional<EvaluationResult> home;
        bool check = false;                // wanted, and not yet computed
        std::vector<std::uint64_t> heard;  // workers that have answered
    };
    void want_check(std::size_t creature);
    // The result that counts, or will count if nothing contradicts it; null without any.
    const EvaluationResult* claimed_result(std::size_t creature) const;
    // Updates the number of settled creatures when an answer changes.
    template <class Change>
    void change(std::size_t creature, Change apply);

    std::vector<Answer> answers_;
    std::vector<std::size_t> checks_;
    std::size_t settled_ = 0;
};

}  // namespace cambrian
