#include "cluster/coordinator/batch.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kUnitsAhead = 3;     // unanswered units per remote core
constexpr std::size_t kMostPlanned = 500;  // creatures per unit, to limit the size of its result
constexpr double kLeastChecked = 0.01;     // least share of a worker's results that is checked
constexpr double kCheckingShare = 0.25;    // largest share of the own cores' time for checks
// An idle core of this machine takes over a unit after this multiple of the expected time and this
// many seconds. Too early a moment costs time that would be idle; a late one delays the generation.
constexpr double kLateFactor = 1.2;
constexpr double kLateGrace = 0.02;
// After twice the time and some more, its worker may have vanished.
constexpr double kSilentFactor = 2.0;
constexpr double kSilentGrace = 0.25;

double checked_share(const Cores& cores) {
    const double own = static_cast<double>(cores.own) / static_cast<double>(cores.all());
    return std::min(kLeastChecked, kCheckingShare * own);
}

std::vector<EvaluationRequest> numbered(std::vector<EvaluationRequest> requests) {
    std::uint32_t place = 0;
    for (EvaluationRequest& request : requests)
        request.slot = place++;
    return requests;
}

}  // namespace

Batch::Batch(std::vector<EvaluationRequest> requests, std::uint32_t generation, Memory& memory)
    : requests_(numbered(std::move(requests))),
      generation_(generation),
      memory_(memory),
      ledger_(memory.costs.seconds_of(requests_)),
      answers_(requests_.size()),
      most_creatures_(kMostPlanned) {}

std::vector<EvaluationRequest> Batch::requests_of(const std::vector<std::size_t>& creatures) const {
    std::vector<EvaluationRequest> requests;
    for (const std::size_t creature : creatures)
        requests.push_back(requests_[creature]);
    return requests;
}

std::optional<Batch::HomeTask> Batch::next_home_task(double now, const Cores& cores) {
    if (auto check = check_task()) return check;
    if (const auto open = ledger_.take_for_home()) return HomeTask{.creatures = {*open}};
    // If no worker can be reached, every unit is late.
    const double moment = cores.remote == 0 ? std::max(now, ledger_.next_due().value_or(now)) : now;
    auto late = ledger_.take_late(moment, cores.own);
    // The leader so far is likely to lead at the end, too, when its check would keep all cores
    // waiting.
    if (!late) return answers_.check_leader() ? check_task() : std::nullopt;
    if (late->first) ++memory_.counts.overdue_at_home;
    HomeTask task{.creatures = std::move(late->creatures), .late = true};
    if (now > late->published + kSilentFactor * (late->due - late->published) + kSilentGrace)
        task.silent_since = late->published;
    return task;
}

std::optional<Batch::HomeTask> Batch::check_task() {
    const auto check = answers_.next_check();
    if (!check) return std::nullopt;
    return HomeTask{.creatures = {*check}};
}

void Batch::finish_at_home(std::size_t creature, EvaluationResult result, const Took& took) {
    if (complete_) return;
    memory_.costs.learn(1, result.work, took.processor);
    if (took.processor > 0.0) memory_.own_pace.learn(took.wall, took.processor);
    core_seconds_ += took.processor;
    if (result.outcome == Outcome::kCompleted) best_ = std::max(best_, result.fitness);
    const std::vector<ResultComparison> comparisons = answers_.compute(creature, std::move(result));
    ledger_.answered(creature);
    for (const ResultComparison& comparison : comparisons)
        compare(comparison);
}

void Batch::compare(const ResultComparison& comparison) {
    ++memory_.counts.checked;
    if (comparison.equal)
        memory_.trust.pass(comparison.worker);
    else
        refuse(comparison.worker);
}

void Batch::refuse(std::uint64_t worker) {
    if (memory_.trust.refused(worker)) return;
    memory_.trust.refuse(worker, "a result differed from that of the coordinator");
    memory_.other_bits.push_back(worker);
    for (const std::size_t creature : answers_.drop_worker(worker))
        ledger_.unanswered(creature);
}

std::optional<Batch::UnitPlan> Batch::next_unit(double now, const Cores& cores) {
    if (cores.remote == 0 || ledger_.outstanding() >= kUnitsAhead * cores.remote)
        return std::nullopt;
    const LeftWork left{.open = ledger_.open_seconds(),
                        .sent = ledger_.outstanding_seconds(),
                        .latency = memory_.latency.value(),
                        .own_pace = memory_.own_pace.value()};
    const double seconds = unit_seconds(left, cores);
    if (seconds <= 0.0) return std::nullopt;
    UnitPlan plan;
    plan.creatures = ledger_.take_for_unit(seconds, most_creatures_);
    if (plan.creatures.empty()) return std::nullopt;
    plan.number = static_cast<std::uint32_t>(published_.size());
    plan.seconds = ledger_.seconds_of(plan.creatures);
    const double before = ledger_.outstanding_seconds() / static_cast<double>(cores.remote);
    const double expected = before + plan.seconds;
    published_.push_back({now, expected});
    ledger_.publish(plan.number, plan.creatures, now,
                    now + kLateFactor * memory_.patience.value() * expected + kLateGrace);
    ++memory_.counts.units;
    return plan;
}

void Batch::not_published(std::uint32_t unit) {
    const std::vector<std::size_t> creatures = ledger_.close(unit);
    if (creatures.empty()) return;
    --memory_.counts.units;
    ledger_.reopen(creatures);
}

void Batch::too_large(const UnitPlan& plan) {
    not_published(plan.number);
    most_creatures_ = plan.creatures.size() / 2;
}

bool Batch::is_answer(const UnitResult& result) const {
    return std::all_of(result.results.begin(), result.results.end(), [&](const SlotResult& each) {
        return each.slot < requests_.size() && each.result.outcome != Outcome::kInterrupted &&
               genome_hash(*requests_[each.slot].genome) == each.genome_hash;
    });
}

std::vector<std::size_t> Batch::close(std::uint32_t unit, double now) {
    std::vector<std::size_t> creatures = ledger_.close(unit);
    if (creatures.empty()) return creatures;
    const Published& published = published_[unit];
    const double turnaround = now - published.at;
    memory_.patience.learn(turnaround / published.expected);
    memory_.latency.learn(turnaround - published.expected);
    return creatures;
}

bool Batch::complete() {
    if (complete_) return true;
    if (!answers_.all_settled() || answers_.check_leader()) return false;
    memory_.last_best = best_;
    complete_ = true;
    return true;
}

std::optional<Batch::Taken> Batch::take_result(std::uint32_t unit, const UnitResult& result,
                                               double now, const Cores& cores) {
    if (!is_answer(result)) return std::nullopt;
    Taken taken;
    if (result.deliveries > 1) ++memory_.counts.redelivered;
    if (complete_) {
        memory_.counts.duplicates += result.results.size();
        return taken;
    }
    if (memory_.trust.refused(result.worker)) {
        ++memory_.counts.refused;
        ledger_.reopen(close(unit, now));
        return taken;
    }
    // A unit is computed on one core, so no honest worker needs more than the time since.
    const double wall = unit < published_.size() ? std::max(0.0, now - published_[unit].at) : 0.0;
    const double seconds = std::clamp(result.seconds, 0.0, wall);
    for (const SlotResult& each : result.results) {
        if (!take_claim(result, each, checked_share(cores))) continue;
        ++taken.creatures;
        taken.work += each.result.work;
    }
    if (taken.creatures == result.results.size()) {
        core_seconds_ += seconds;
        memory_.costs.learn(taken.creatures, taken.work, seconds);
    }
    // A worker may have computed a part of a unit; the other creatures are open again.
    std::vector<std::size_t> left;
    for (const std::size_t creature : close(unit, now)) {
        if (!answers_.claimed(creature)) left.push_back(creature);
    }
    ledger_.reopen(left);
    return taken;
}

bool Batch::take_claim(const UnitResult& unit, const SlotResult& each, double least) {
    // The worker may have been refused by an earlier result of the same unit.
    if (memory_.trust.refused(unit.worker)) return false;
    if (!answers_.hears(each.slot, unit.worker)) {
        ++memory_.counts.duplicates;
        return false;
    }
    const bool drawn = memory_.trust.draw_check(unit.worker, generation_, each.slot, least);
    // Few creatures lead the last batch's best; the best of a batch is always checked at its end.
    const bool completed = each.result.outcome == Outcome::kCompleted;
    const bool leads = completed && each.result.fitness > std::max(best_, memory_.last_best);
    if (completed) best_ = std::max(best_, each.result.fitness);
    const auto claimed = answers_.claim(each.slot, unit.worker, each.result, drawn || leads);
    ledger_.answered(each.slot);
    if (claimed.first) return true;
    ++memory_.counts.duplicates;
    if (claimed.comparison) compare(*claimed.comparison);
    return true;
}

}  // namespace cambrian
