// The ledgers of units, their sizes, trust and presence, with a clock that the test sets.

#include "cluster/coordinator/answers.h"
#include "cluster/coordinator/batch.h"
#include "cluster/coordinator/fading_ratio.h"
#include "cluster/coordinator/running_quantile.h"
#include "cluster/coordinator/trust.h"
#include "cluster/coordinator/unit_ledger.h"
#include "cluster/coordinator/unit_sizing.h"
#include "cluster/coordinator/worker_roster.h"
#include "cluster/messages/hello_text.h"
#include "cluster/messages/proof_set.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <numeric>
#include <set>

using namespace cambrian;
using test::kinds;
using List = std::vector<std::size_t>;

TEST_CASE("units shrink as less is left", "[cluster]") {
    CHECK(unit_seconds({.open = 1'000.0}, {.own = 1, .remote = 7}) == 2.0);
    CHECK(unit_seconds({.open = 16.0}, {.own = 1, .remote = 7}) == 0.5);
    CHECK(unit_seconds({.open = 0.032}, {.own = 1, .remote = 7}) == 0.01);
    double left = 80.0;
    int units = 0;
    for (double last = 1e9; left > 1e-9; ++units) {
        const Cores cores{.own = 8, .remote = 8};
        const double unit = std::min(left, unit_seconds({.open = left}, cores));
        CHECK(unit <= last);
        last = unit;
        left -= unit;
    }
    CHECK(units < 1'000);
}

TEST_CASE("workers get no more than they can do while the own cores do the rest", "[cluster]") {
    // Half of a batch of 6 ms on two cores stays with the coordinator.
    CHECK(unit_seconds({.open = 0.006}, {.own = 1, .remote = 1}) == Approx(0.003));
    CHECK(unit_seconds({.open = 0.006}, {.own = 1, .remote = 5}) == Approx(0.005));
    // A unit of 4 ms and one more of 8 ms take as long as what is then open.
    CHECK(unit_seconds({.open = 0.020, .sent = 0.004}, {.own = 1, .remote = 1}) == Approx(0.008));
    CHECK(unit_seconds({.open = 0.020, .sent = 0.021}, {.own = 1, .remote = 1}) < 0.0);
    // A unit comes back after 5 ms more than its work, or an own core takes twice as long.
    CHECK(unit_seconds({.open = 0.020, .latency = 0.005}, {.own = 1, .remote = 1}) ==
          Approx(0.0075));
    CHECK(unit_seconds({.open = 0.020, .latency = 0.030}, {.own = 1, .remote = 7}) < 0.0);
    CHECK(unit_seconds({.open = 0.015, .own_pace = 2.0}, {.own = 1, .remote = 1}) == Approx(0.010));
    // Own cores that several runs share keep no more than their number.
    const LeftWork busy{.open = 0.006, .sent = 1.0, .latency = 1.0, .own_pace = 9.0};
    CHECK(unit_seconds(busy, {.own = 1, .remote = 1}) == Approx(0.003));
    CHECK(unit_seconds({.open = 0.0, .sent = 0.004}, {.own = 1, .remote = 7}) < 0.0);
    CHECK(unit_seconds({}, {.own = 1, .remote = 7}) == 0.0);
}

TEST_CASE("costs are learnt, and unknown ones are the median", "[cluster]") {
    CostModel model;
    for (int i = 0; i < 1'000; ++i)
        model.learn(2, 2'000, 1.0);
    std::vector<EvaluationRequest> requests(4);
    requests[0].expected_work = 1'000;
    requests[1].expected_work = 4'000;
    requests[2].expected_work = 2'000;
    const std::vector<double> seconds = model.seconds_of(requests);
    CHECK(seconds[0] == Approx(0.5).epsilon(1e-3));
    CHECK(seconds[1] == Approx(2.0).epsilon(1e-3));
    CHECK(seconds[3] == Approx(1.0).epsilon(1e-3));
    model.learn(1, 0, 1.0);
    model.learn(1, 5, 0.0);
    CHECK(model.seconds_of(requests) == seconds);
    // A creature that was rejected at once is no basis for an estimate of the others.
    for (int i = 0; i < 100; ++i) {
        model.learn(1, 1'000, 0.5);
        model.learn(1, 1, 0.01);
    }
    CHECK(model.seconds_of(requests)[0] == Approx(0.5).epsilon(0.05));
}

TEST_CASE("the ledger hands out long creatures to others and short ones at home", "[cluster]") {
    UnitLedger ledger({8.0, 4.0, 2.0, 1.0, 1.0});
    CHECK(ledger.open_seconds() == 16.0);
    CHECK(ledger.take_for_unit(5.0, 10) == List{0});
    CHECK(ledger.take_for_unit(5.0, 10) == List{1, 2});
    CHECK(ledger.take_for_home() == 4U);
    CHECK(ledger.take_for_unit(100.0, 10) == List{3});
    CHECK(ledger.open_seconds() == 0.0);
    CHECK_FALSE(ledger.take_for_home());
    CHECK(ledger.take_for_unit(1.0, 10).empty());
}

TEST_CASE("late units come home in parts, the last creatures first", "[cluster]") {
    UnitLedger ledger(std::vector<double>(6, 1.0));
    ledger.publish(0, ledger.take_for_unit(4.0, 10), 1.0, 10.0);
    ledger.publish(1, ledger.take_for_unit(2.0, 10), 2.0, 5.0);
    CHECK(ledger.next_due() == 5.0);
    CHECK_FALSE(ledger.take_late(4.9, 2));
    auto late = ledger.take_late(20.0, 2);
    REQUIRE(late);
    CHECK(late->unit == 1);
    CHECK(late->published == 2.0);
    CHECK(late->first);
    CHECK(late->creatures == List{5});
    late = ledger.take_late(20.0, 2);
    CHECK_FALSE(late->first);
    CHECK(late->creatures == List{4});
    CHECK(ledger.take_late(20.0, 2)->creatures == List{3, 2});
    ledger.answered(1);
    CHECK(ledger.take_late(20.0, 2)->creatures == List{0});
    CHECK_FALSE(ledger.take_late(20.0, 2));
    CHECK_FALSE(ledger.next_due());
}

TEST_CASE("creatures of units that come to nothing are open again, once", "[cluster]") {
    UnitLedger ledger(std::vector<double>(4, 1.0));
    ledger.publish(0, ledger.take_for_unit(3.0, 10), 0.5, 1.0);
    CHECK(ledger.outstanding_seconds() == 3.0);
    ledger.answered(1);
    ledger.reopen(ledger.close(0));
    ledger.reopen({0});
    CHECK(ledger.outstanding() == 0);
    CHECK(ledger.open_seconds() == 3.0);
    CHECK(ledger.take_for_unit(100.0, 10) == List{0, 2, 3});
    CHECK(ledger.close(0).empty());
    CHECK(ledger.close(99).empty());
    ledger.unanswered(1);
    CHECK(ledger.take_for_home() == 1U);
    ledger.publish(7, {0}, 2.0, 1e9);
    ledger.expect_no_more(7);
    CHECK(ledger.take_late(1.0, 1)->creatures == List{0});
}

namespace {

EvaluationResult with_fitness(double fitness) {
    EvaluationResult result;
    result.fitness = fitness;
    return result;
}

}  // namespace

TEST_CASE("the first answer counts and later ones are compared with it", "[cluster]") {
    Answers answers(2);
    CHECK(answers.claim(0, 1, with_fitness(1.0), false).first);
    CHECK(answers.settled(0));
    CHECK_FALSE(answers.claim(0, 2, with_fitness(1.0), false).first);
    CHECK(answers.settled(0));
    // The answers differ, so the coordinator's own cores decide.
    CHECK_FALSE(answers.claim(0, 3, with_fitness(1.5), false).first);
    CHECK_FALSE(answers.settled(0));
    CHECK(answers.next_check() == 0U);
    CHECK_FALSE(answers.next_check());
    const auto comparisons = answers.compute(0, with_fitness(1.5));
    REQUIRE(comparisons.size() == 3);
    CHECK_FALSE(comparisons[0].equal);
    CHECK_FALSE(comparisons[1].equal);
    CHECK(comparisons[2].equal);
    CHECK(answers.result(0)->fitness == 1.5);
    // A later answer is compared with the coordinator's own result.
    const auto late = answers.claim(0, 4, with_fitness(1.0), false);
    REQUIRE(late.comparison);
    CHECK_FALSE(late.comparison->equal);
    CHECK(answers.settled() == 1);
    CHECK_FALSE(answers.all_settled());
}

TEST_CASE("a worker answers once for a creature", "[cluster]") {
    Answers answers(2);
    CHECK(answers.hears(0, 1));
    answers.claim(0, 1, with_fitness(1.0), false);
    CHECK_FALSE(answers.hears(0, 1));
    CHECK(answers.hears(0, 2));
    CHECK(answers.hears(1, 1));
    answers.compute(0, with_fitness(1.0));
    CHECK_FALSE(answers.hears(0, 1));
}

TEST_CASE("copies of a true result buy no checks", "[cluster]") {
    Batch::Memory memory{.trust = Trust(1)};
    constexpr std::size_t kCreatures = 17;
    std::vector<EvaluationRequest> requests(kCreatures);
    for (EvaluationRequest& request : requests)
        request.genome = std::make_shared<const Genome>();
    Batch batch(requests, 1, memory);
    const Cores cores{.own = 1, .remote = 99};
    const auto answer = [&](std::uint32_t slot, double fitness) {
        UnitResult unit;
        unit.worker = 7;
        unit.results = {{slot, genome_hash(*requests[slot].genome), with_fitness(fitness)}};
        return batch.take_result(0, unit, 0.0, cores);
    };
    for (int copy = 0; copy < 3'000; ++copy) {
        const auto taken = answer(0, 1.0);
        REQUIRE(taken);
        CHECK(taken->creatures == (copy == 0 ? 1U : 0U));
    }
    CHECK(memory.counts.duplicates == 2'999);
    // The next fifteen are checked as ever.
    for (std::uint32_t slot = 1; slot < 16; ++slot)
        answer(slot, 0.5);
    CHECK(batch.settled() == 0);
    answer(16, 0.5);
    std::size_t checks = 0;
    while (const auto task = batch.next_home_task(0.0, cores)) {
        if (task->late) break;
        checks += task->creatures.size();
    }
    CHECK(checks >= 16);
}

TEST_CASE("answers that only a refused worker gave are revoked", "[cluster]") {
    Answers answers(4);
    answers.claim(0, 1, with_fitness(1.0), false);
    answers.claim(1, 1, with_fitness(1.0), false);
    answers.claim(1, 2, with_fitness(1.0), false);
    answers.claim(2, 1, with_fitness(1.0), true);
    answers.claim(3, 1, with_fitness(1.0), false);
    answers.compute(3, with_fitness(1.0));
    CHECK(answers.drop_worker(1) == List{0, 2});
    CHECK_FALSE(answers.settled(0));
    CHECK(answers.settled(1));
    CHECK(answers.settled(3));
    CHECK_FALSE(answers.next_check());
}

TEST_CASE("the best creature is computed at home before it counts", "[cluster]") {
    Answers answers(3);
    answers.compute(0, with_fitness(1.0));
    answers.claim(1, 1, with_fitness(3.0), false);
    EvaluationResult failed = with_fitness(9.0);
    failed.outcome = Outcome::kDiverged;
    answers.claim(2, 1, failed, false);
    CHECK(answers.all_settled());
    CHECK(answers.check_leader());
    CHECK_FALSE(answers.all_settled());
    CHECK(answers.next_check() == 1U);
    answers.compute(1, with_fitness(3.0));
    CHECK(answers.all_settled());
    CHECK_FALSE(answers.check_leader());
}

TEST_CASE("a leader can be checked before all others have answered", "[cluster]") {
    Answers answers(3);
    CHECK_FALSE(answers.check_leader());
    answers.claim(0, 1, with_fitness(2.0), false);
    answers.claim(1, 1, with_fitness(3.0), false);
    CHECK(answers.check_leader());
    CHECK(answers.next_check() == 1U);
    // While this check is computed, no other one is wanted.
    CHECK(answers.check_leader());
    CHECK_FALSE(answers.next_check());
    answers.compute(1, with_fitness(3.0));
    CHECK_FALSE(answers.check_leader());
    answers.claim(2, 1, with_fitness(4.0), false);
    CHECK(answers.check_leader());
    CHECK(answers.next_check() == 2U);
}

TEST_CASE("idle cores check the leader of an unfinished batch", "[cluster]") {
    Batch::Memory memory{.trust = Trust(1)};
    // The worker is known, so few of its results are drawn.
    memory.last_best = 100.0;
    for (std::uint32_t slot = 0; slot < 1'000'000; ++slot)
        memory.trust.draw_check(7, 1, slot, 0.0);
    std::vector<EvaluationRequest> requests(4);
    for (EvaluationRequest& request : requests) {
        request.genome = std::make_shared<const Genome>();
        request.expected_work = 1'000'000;
    }
    Batch batch(requests, 1, memory);
    const Cores cores{.own = 1, .remote = 1};
    const auto first = batch.next_unit(0.0, cores);
    REQUIRE(first);
    CHECK(first->creatures == List{0});
    const auto second = batch.next_unit(0.0, cores);
    REQUIRE(second);
    CHECK(second->creatures == List{1});
    // The workers have their share.
    CHECK_FALSE(batch.next_unit(0.0, cores));
    for (const std::size_t open : {3U, 2U}) {
        CHECK(batch.next_home_task(0.1, cores)->creatures == List{open});
        batch.finish_at_home(open, with_fitness(1.0), {3.0, 3.0});
    }
    CHECK_FALSE(batch.next_home_task(0.2, cores));
    UnitResult result;
    result.worker = 7;
    result.results = {{0, genome_hash(*requests[0].genome), with_fitness(2.0)}};
    REQUIRE(batch.take_result(0, result, 0.3, cores));
    const auto check = batch.next_home_task(0.4, cores);
    REQUIRE(check);
    CHECK(check->creatures == List{0});
    CHECK_FALSE(check->late);
    CHECK_FALSE(batch.next_home_task(0.5, cores));
    batch.finish_at_home(0, with_fitness(2.0), {3.0, 3.0});
    result.results = {{1, genome_hash(*requests[1].genome), with_fitness(1.5)}};
    REQUIRE(batch.take_result(1, result, 0.6, cores));
    CHECK(batch.complete());
}

TEST_CASE("a leader is checked at once, also where all scores are negative", "[cluster]") {
    std::vector<EvaluationRequest> requests(4);
    for (EvaluationRequest& request : requests) {
        request.genome = std::make_shared<const Genome>();
        request.expected_work = 1'000'000;
    }
    // Returns what the own core does after a proven worker's result for creature 0.
    const auto next_after = [&](double fitness, Batch::Memory memory) {
        for (std::uint32_t slot = 0; slot < 1'000'000; ++slot)
            memory.trust.draw_check(7, 1, slot, 0.0);
        Batch batch(requests, 1, memory);
        const Cores cores{.own = 1, .remote = 1};
        REQUIRE(batch.next_unit(0.0, cores)->creatures == List{0});
        UnitResult result;
        result.worker = 7;
        result.results = {{0, genome_hash(*requests[0].genome), with_fitness(fitness)}};
        REQUIRE(batch.take_result(0, result, 0.1, cores));
        return batch.next_home_task(0.2, cores)->creatures;
    };
    CHECK(next_after(-3.0, {.trust = Trust(1)}) == List{0});
    CHECK(next_after(-3.0, {.trust = Trust(1), .last_best = -4.0}) == List{0});
    CHECK(next_after(-5.0, {.trust = Trust(1), .last_best = -4.0}) != List{0});
}

TEST_CASE("new workers are checked much, proven ones a little", "[cluster]") {
    Trust trust(42);
    int first = 0;
    int later = 0;
    constexpr std::uint32_t kResults = 100'000;
    for (std::uint32_t slot = 0; slot < kResults; ++slot) {
        const bool checked = trust.draw_check(7, 1, slot, 0.01);
        if (slot < 16) first += checked ? 1 : 0;
        if (slot >= 10'000) later += checked ? 1 : 0;
    }
    CHECK(first == 16);
    CHECK(later > 700);
    CHECK(later < 1'100);
    // Another secret selects other answers to check.
    Trust same(42);
    Trust other(43);
    std::set<std::uint32_t> of_same;
    std::set<std::uint32_t> of_other;
    for (std::uint32_t slot = 0; slot < 1'000; ++slot) {
        if (same.draw_check(7, 1, slot, 0.01)) of_same.insert(slot);
        if (other.draw_check(7, 1, slot, 0.01)) of_other.insert(slot);
    }
    CHECK(of_same != of_other);
    trust.refuse(7, "why");
    trust.refuse(7, "again");
    CHECK(trust.refused(7));
    CHECK_FALSE(trust.refused(8));
    CHECK(trust.refusals() == std::vector<Refusal>{{7, "why"}});
}

namespace {

Hello hello_of(std::uint64_t id, int cores) {
    Hello hello;
    hello.id = id;
    hello.name = "machine " + std::to_string(id);
    hello.cores = cores;
    hello.simulator = "1.2";
    hello.proof = 5;
    return hello;
}

}  // namespace

TEST_CASE("only workers that are heard and compute the same bits count", "[cluster]") {
    Trust trust(1);
    WorkerRoster roll({"1.2", 5}, "here", 2);
    roll.hear(hello_of(1, 8), "lab", 100.0, trust);
    roll.hear(hello_of(2, 4), "lab", 103.0, trust);
    Hello newer = hello_of(3, 16);
    newer.simulator = "1.3";
    roll.hear(newer, "lab", 103.0, trust);
    Hello odd = hello_of(4, 16);
    odd.proof = 6;
    roll.hear(odd, "lab", 103.0, trust);
    CHECK(roll.cores(104.0, trust) == 12);
    CHECK(roll.cores(106.5, trust) == 4);
    // After a late unit, workers that have been silent since then are in doubt until they send a
    // message.
    roll.hear(hello_of(1, 8), "lab", 106.6, trust);
    roll.doubt_silent(106.5);
    CHECK(roll.cores(106.7, trust) == 8);
    roll.worked(2, 10, 1'000, 106.8);
    CHECK(roll.cores(106.8, trust) == 12);
    trust.refuse(2, "a result differed");
    CHECK(roll.cores(106.8, trust) == 8);
    Hello bye = hello_of(1, 8);
    bye.leaving = true;
    roll.worked_at_home(5, 1'000, 106.9);
    const auto rows = roll.rows(107.0, trust, {.own_busy = true, .reachable = true});
    REQUIRE(rows.size() == 5);
    CHECK(rows[0].name == "here");
    CHECK(rows[0].state == WorkerState::kWorking);
    CHECK(rows[0].share == 0.5);
    CHECK(rows[1].state == WorkerState::kIdle);
    CHECK(rows[2].refusal == "a result differed");
    CHECK(rows[2].share == 0.5);
    CHECK(rows[3].refusal == "simulator 1.3, this run is of 1.2");
    CHECK(rows[4].refusal == "other bits in the proof set");
    CHECK(roll.rows(107.0, trust, {.own_busy = false, .reachable = false})[1].state ==
          WorkerState::kAway);
    CHECK(roll.rows(113.0, trust, {.own_busy = false, .reachable = true})[1].state ==
          WorkerState::kAway);
    roll.hear(bye, "lab", 107.0, trust);
    CHECK(roll.cores(107.0, trust) == 0);
    CHECK(roll.rows(107.0, trust, {}).size() == 4);
    // The user still sees why a refused worker has left.
    bye.id = 2;
    roll.hear(bye, "lab", 107.0, trust);
    CHECK(roll.rows(107.0, trust, {})[1].refusal == "a result differed");
    CHECK(roll.cores(107.0, trust) == 0);
}

TEST_CASE("an id belongs to the login that announced it first", "[cluster]") {
    const Trust trust(1);
    WorkerRoster roll({"1.2", 5}, "here", 2);
    CHECK_FALSE(roll.counts(1, "lab"));
    roll.hear(hello_of(1, 8), "lab", 100.0, trust);
    CHECK(roll.counts(1, "lab"));
    CHECK_FALSE(roll.counts(1, "other"));
    Hello bye = hello_of(1, 99);
    roll.hear(bye, "other", 100.0, trust);
    CHECK(roll.cores(100.0, trust) == 8);
    bye.leaving = true;
    roll.hear(bye, "other", 100.0, trust);
    CHECK(roll.counts(1, "lab"));
    Hello odd = hello_of(2, 8);
    odd.proof = 6;
    roll.hear(odd, "lab", 100.0, trust);
    CHECK_FALSE(roll.counts(2, "lab"));
    // One login cannot fill the roll.
    for (std::uint64_t id = 10; id < 5'000; ++id)
        roll.hear(hello_of(id, 1), "other", 100.0, trust);
    roll.hear(hello_of(3, 8), "lab", 100.0, trust);
    CHECK(roll.counts(3, "lab"));
    CHECK(roll.rows(100.0, trust, {}).size() < 2'100);
}

TEST_CASE("presence keeps its fields, and is cut to what may be shown", "[cluster]") {
    Hello hello = hello_of(9, 3);
    hello.role = Hello::Role::kCoordinator;
    hello.busy = 2;
    hello.units_per_second = 0.1;
    hello.refusals = {{4, "other bits"}};
    hello.trials = {{"walking, x", 17}};
    const Result<Hello> read = parse_hello(hello_text(hello));
    REQUIRE(read);
    CHECK(*read == hello);
    hello.name = std::string(39, 'a') + "\xc3\xa9\x1b[31m";
    hello.refused = std::string(1'000, 'r');
    for (std::uint64_t i = 0; i < 50; ++i)
        hello.refusals.push_back({i, std::string(1'000, 'x')});
    const ProofTrial trial{.name = std::string(40, 'n'), .digest = 1};
    hello.trials.resize(10, trial);
    const std::string text = hello_text(hello);
    CHECK(text.size() <= 4'000);
    const Result<Hello> cut = parse_hello(text);
    INFO((cut ? std::string() : cut.error().message));
    REQUIRE(cut);
    CHECK(cut->name == std::string(39, 'a'));
    CHECK(cut->refusals.size() == 10);
    CHECK_FALSE(parse_hello(""));
    CHECK_FALSE(parse_hello(std::string(4'001, ' ')));
}

TEST_CASE("the proof set moves creatures towards every goal", "[cluster]") {
    const std::vector<ProofTrial> trials = proof_trials(kinds());
    CHECK(trials.size() == 2 * kinds().goals.size());
    CHECK(trials == proof_trials(kinds()));
    std::set<std::uint64_t> digests;
    for (const ProofTrial& trial : trials)
        digests.insert(trial.digest);
    CHECK(digests.size() == trials.size());
    std::vector<ProofTrial> other = trials;
    other[1].digest ^= 1U;
    CHECK(proof_of(other) != proof_of(trials));
    CHECK(differing_trials(trials, other) == trials[1].name);
    CHECK(differing_trials(trials, trials).empty());
}

TEST_CASE("the proof set notices a light, a muscle or a sense that differs", "[cluster]") {
    const std::vector<ProofTrial> expected = proof_trials(kinds());
    for (const std::string_view changed : {"joint-rate", "spin", "balance", "light", "stretch"}) {
        EvolutionKinds other = kinds();
        other.creature.sensors = {};
        for (SensorKind sensor : kinds().creature.sensors.all()) {
            if (sensor.id == changed) sensor.read = [](const SensorSite&, double&) { return 0.5; };
            other.creature.sensors.add(std::move(sensor));
        }
        CAPTURE(changed);
        CHECK_FALSE(differing_trials(expected, proof_trials(other)).empty());
    }
    EvolutionKinds rigid = kinds();
    rigid.creature.organs = {};
    for (OrganKind organ : kinds().creature.organs.all()) {
        if (organ.shape != nullptr)
            organ.shape = [](std::span<const double>, const SceneSettings&, PlannedPart&) {};
        rigid.creature.organs.add(std::move(organ));
    }
    CHECK_FALSE(differing_trials(expected, proof_trials(rigid)).empty());
}

TEST_CASE("the seventh decile follows most samples, not a few slow ones", "[cluster]") {
    RunningQuantile ratio(1.0, 100.0);
    for (int unit = 0; unit < 1'000; ++unit)
        ratio.learn(0.5);
    CHECK(ratio.value() == 1.0);
    // Units that wait for those of other runs take four times their expected time.
    for (int unit = 0; unit < 1'000; ++unit)
        ratio.learn(4.0);
    CHECK(ratio.value() == Approx(4.0).epsilon(0.06));
    // One unit of five is held by a slow worker.
    for (int unit = 0; unit < 5'000; ++unit)
        ratio.learn(unit % 5 == 0 ? 40.0 : 2.0);
    CHECK(ratio.value() == Approx(2.0).epsilon(0.06));
    for (int unit = 0; unit < 1'000; ++unit)
        ratio.learn(1e6);
    CHECK(ratio.value() == 100.0);
}

TEST_CASE("a ratio weighs long times more, and forgets", "[cluster]") {
    FadingRatio ratio(50.0);
    CHECK(ratio.value() == 1.0);
    // One creature of ten waits for the processor a hundred times as long as it computes.
    for (int creature = 0; creature < 1'000; ++creature)
        ratio.learn(creature % 10 == 0 ? 0.3 : 0.003, 0.003);
    CHECK(ratio.value() > 9.0);
    CHECK(ratio.value() < 13.0);
    for (int creature = 0; creature < 500; ++creature)
        ratio.learn(0.006, 0.003);
    CHECK(ratio.value() == Approx(2.0).epsilon(1e-3));
}

TEST_CASE("a late unit comes home early and casts doubt on its worker only later", "[cluster]") {
    Batch::Memory memory{.trust = Trust(1)};
    auto genome = std::make_shared<Genome>();
    genome->nodes.resize(1);
    std::vector<EvaluationRequest> requests(1);
    requests[0].genome = genome;
    Batch batch(requests, 1, memory);
    const Cores cores{.own = 1, .remote = 3};
    const auto plan = batch.next_unit(10.0, cores);
    REQUIRE(plan);
    const double due = 10.0 + 1.2 * plan->seconds + 0.02;
    CHECK(batch.next_due() == Approx(due));
    CHECK_FALSE(batch.next_home_task(due - 1e-6, cores));
    SECTION("just after its due time") {
        const auto task = batch.next_home_task(due + 1e-6, cores);
        REQUIRE(task);
        CHECK(task->late);
        CHECK_FALSE(task->silent_since);
    }
    SECTION("long after its due time") {
        const auto task = batch.next_home_task(10.0 + 2.0 * (due - 10.0) + 0.26, cores);
        REQUIRE(task);
        CHECK(task->silent_since == 10.0);
    }
}

TEST_CASE("answers to another batch are told apart", "[cluster]") {
    Batch::Memory memory{.trust = Trust(1)};
    auto genome = std::make_shared<Genome>();
    genome->nodes.resize(1);
    std::vector<EvaluationRequest> requests(3);
    for (EvaluationRequest& request : requests)
        request.genome = genome;
    Batch batch(requests, 1, memory);
    const Cores cores{.own = 1, .remote = 3};
    const auto plan = batch.next_unit(0.0, cores);
    REQUIRE(plan);
    const auto answer = [&](std::uint32_t slot, std::uint64_t hash) {
        UnitResult unit;
        unit.worker = 1;
        unit.results.push_back({slot, hash, with_fitness(1.0)});
        return batch.take_result(plan->number, unit, 0.0, cores);
    };
    CHECK_FALSE(answer(3, genome_hash(*genome)));
    CHECK_FALSE(answer(0, genome_hash(*genome) ^ 1U));
    CHECK(batch.settled() == 0);
    CHECK(answer(0, genome_hash(*genome)));
}

TEST_CASE("a complete batch stays complete when another answer arrives", "[cluster]") {
    Batch::Memory memory{.trust = Trust(1)};
    for (std::uint32_t slot = 0; slot < 10'000; ++slot)
        memory.trust.draw_check(1, 0, slot, 0.0);  // worker 1 is proven, worker 2 is new
    auto genome = std::make_shared<Genome>();
    genome->nodes.resize(1);
    std::vector<EvaluationRequest> requests(2);
    for (EvaluationRequest& request : requests)
        request.genome = genome;
    Batch batch(requests, 1, memory);
    const Cores cores{.own = 1, .remote = 99};
    const auto plan = batch.next_unit(0.0, cores);
    REQUIRE(plan);
    batch.finish_at_home(1, with_fitness(2.0), {0.1, 0.1});
    const auto answer = [&](std::uint64_t worker, double fitness) {
        UnitResult unit;
        unit.worker = worker;
        unit.results.push_back({0, genome_hash(*genome), with_fitness(fitness)});
        return batch.take_result(plan->number, unit, 0.0, cores);
    };
    CHECK(answer(1, 1.0));
    REQUIRE(batch.complete());
    const double fitness = GENERATE(1.0, 1.5, 3.0);
    CHECK(answer(2, fitness));
    CHECK(batch.complete());
    CHECK(batch.settled() == 2);
    CHECK(batch.result(0)->fitness == 1.0);
    CHECK(memory.counts.duplicates == 1);
    batch.finish_at_home(0, with_fitness(fitness), {0.1, 0.1});
    CHECK(batch.complete());
    CHECK(batch.result(0)->fitness == 1.0);
}
