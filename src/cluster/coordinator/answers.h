#pragma once

// What was answered of a batch, by whom, and what of it is certain. The own cores' results are the
// truth that workers' results are compared with; those of two workers are compared with each other.

#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cambrian {

// How a worker's result compared with that of the own cores.
struct Comparison {
    std::uint64_t worker = 0;
    bool equal = false;  // every bit
};

class Answers {
public:
    explicit Answers(std::size_t creatures) : answers_(creatures) {}

    // A worker's result. check: it does not count until the own cores have computed it too.
    struct Claimed {
        bool first = false;  // of this creature
        std::optional<Comparison> comparison;
    };
    Claimed claim(std::size_t creature, std::uint64_t worker, EvaluationResult result, bool check);
    // The own cores' result; how it compares with each claim.
    std::vector<Comparison> compute(std::size_t creature, EvaluationResult result);
    // Takes back what nobody else claims too. Creatures that lost their result that way.
    std::vector<std::size_t> drop_worker(std::uint64_t worker);

    // Whether somebody answered it, for certain or not.
    bool claimed(std::size_t creature) const {
        return answers_[creature].home || !answers_[creature].claims.empty();
    }
    // Whether the creature has a result that counts.
    bool settled(std::size_t creature) const;
    std::size_t settled() const { return settled_; }
    bool all_settled() const { return settled_ == answers_.size(); }
    // The result that counts; null unless settled.
    const EvaluationResult* result(std::size_t creature) const;

    // A creature to be computed at home to check it, the earliest first; each is told once.
    std::optional<std::size_t> next_check();
    bool checks_waiting() const { return !checks_.empty(); }
    // Asks for the check of the best completed creature, unless it is certain. Whether it did.
    bool check_leader();

private:
    struct Claim {
        std::uint64_t worker = 0;
        EvaluationResult result;
    };
    struct Answer {
        std::vector<Claim> claims;
        std::optional<EvaluationResult> home;
        bool check = false;  // wanted, and not yet computed
    };
    void want_check(std::size_t creature);
    // Keeps count of the settled ones around a change of an answer.
    template <class Change>
    void change(std::size_t creature, Change apply);

    std::vector<Answer> answers_;
    std::vector<std::size_t> checks_;
    std::size_t settled_ = 0;
};

}  // namespace cambrian
