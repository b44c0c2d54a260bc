#include "cluster/coordinator/answers.h"

#include "cluster/messages/result_text.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostHeard = 16;  // workers a creature

}  // namespace

bool Answers::settled(std::size_t creature) const {
    const Answer& answer = answers_[creature];
    return answer.home || (!answer.claims.empty() && !answer.check);
}

const EvaluationResult* Answers::result(std::size_t creature) const {
    return settled(creature) ? claimed_result(creature) : nullptr;
}

template <class Change>
void Answers::change(std::size_t creature, Change apply) {
    const bool before = settled(creature);
    apply(answers_[creature]);
    const bool after = settled(creature);
    if (after && !before) ++settled_;
    if (before && !after) --settled_;
}

void Answers::want_check(std::size_t creature) {
    if (answers_[creature].check || answers_[creature].home) return;
    change(creature, [](Answer& answer) { answer.check = true; });
    checks_.push_back(creature);
}

bool Answers::hears(std::size_t creature, std::uint64_t worker) const {
    const std::vector<std::uint64_t>& heard = answers_[creature].heard;
    return heard.size() < kMostHeard &&
           std::find(heard.begin(), heard.end(), worker) == heard.end();
}

Answers::Claimed Answers::claim(std::size_t creature, std::uint64_t worker, EvaluationResult result,
                                bool check) {
    answers_[creature].heard.push_back(worker);
    const Answer& answer = answers_[creature];
    if (answer.home) return {false, ResultComparison{worker, same_result(result, *answer.home)}};
    const bool first = answer.claims.empty();
    const bool disputed = !first && !same_result(result, answer.claims.front().result);
    change(creature, [&](Answer& each) { each.claims.push_back({worker, std::move(result)}); });
    if (check || disputed) want_check(creature);
    return {first, std::nullopt};
}

std::vector<ResultComparison> Answers::compute(std::size_t creature, EvaluationResult result) {
    std::vector<ResultComparison> comparisons;
    for (const Claim& claim : answers_[creature].claims)
        comparisons.push_back({claim.worker, same_result(claim.result, result)});
    change(creature, [&](Answer& answer) {
        if (!answer.home) answer.home = std::move(result);
        answer.claims.clear();
        answer.check = false;
    });
    std::erase(checks_, creature);
    return comparisons;
}

std::vector<std::size_t> Answers::drop_worker(std::uint64_t worker) {
    std::vector<std::size_t> lost;
    for (std::size_t creature = 0; creature < answers_.size(); ++creature) {
        bool had = false;
        change(creature, [&](Answer& answer) {
            had = std::erase_if(answer.claims,
                                [&](const Claim& claim) { return claim.worker == worker; }) > 0;
            if (answer.claims.empty()) answer.check = false;
        });
        if (!had || answers_[creature].home || !answers_[creature].claims.empty()) continue;
        std::erase(checks_, creature);
        lost.push_back(creature);
    }
    return lost;
}

std::optional<std::size_t> Answers::next_check() {
    if (checks_.empty()) return std::nullopt;
    const std::size_t creature = checks_.front();
    checks_.erase(checks_.begin());
    return creature;
}

const EvaluationResult* Answers::claimed_result(std::size_t creature) const {
    const Answer& answer = answers_[creature];
    if (answer.home) return &*answer.home;
    return answer.claims.empty() ? nullptr : &answer.claims.front().result;
}

bool Answers::check_leader() {
    std::optional<std::size_t> best;
    for (std::size_t creature = 0; creature < answers_.size(); ++creature) {
        const EvaluationResult* each = claimed_result(creature);
        if (each == nullptr || each->outcome != Outcome::kCompleted) continue;
        if (!best || each->fitness > claimed_result(*best)->fitness) best = creature;
    }
    if (!best || answers_[*best].home) return false;
    want_check(*best);
    return true;
}

}  // namespace cambrian
