#include "cluster/messages/result_text.h"

#include "cluster/messages/exact_real.h"
#include "core/random.h"
#include "support/catch.h"

#include <bit>
#include <limits>

using namespace cambrian;

namespace {

// Returns any bits, including infinities, not-a-number and the smallest numbers.
double any_real(RandomStream& random) {
    static const std::vector<double> kOdd = {0.0,
                                             -0.0,
                                             std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity(),
                                             std::numeric_limits<double>::denorm_min(),
                                             -std::numeric_limits<double>::denorm_min(),
                                             std::numeric_limits<double>::max(),
                                             0.1,
                                             1.0};
    return random.chance(0.3) ? random.pick(kOdd) : std::bit_cast<double>(random.bits());
}

std::uint64_t any_count(RandomStream& random) {
    return random.bits() >> 11;  // doubles represent integers up to this size exactly
}

void fill(Behavior& behavior, RandomStream& random) {
    for (double* each :
         {&behavior.settled_height, &behavior.contact_share, &behavior.joint_frequency,
          &behavior.mean_joint_frequency, &behavior.travel, &behavior.stir})
        *each = any_real(random);
    behavior.movable_joints = random.between(0, 100);
}

void fill(SceneAudit& audit, RandomStream& random) {
    for (double* each :
         {&audit.motor_work, &audit.gross_motor_work, &audit.drag_work, &audit.contact_work,
          &audit.limit_work, &audit.impulse_work, &audit.positive_work, &audit.energy_residual,
          &audit.energy_scale, &audit.max_penetration, &audit.max_limit_overrun,
          &audit.max_part_speed, &audit.max_part_spin})
        *each = any_real(random);
    for (std::uint64_t* each :
         {&audit.evaluations, &audit.steps, &audit.rejections, &audit.events, &audit.fallbacks})
        *each = any_count(random);
}

EvaluationResult any_result(RandomStream& random) {
    EvaluationResult result;
    result.fitness = any_real(random);
    result.outcome = static_cast<Outcome>(random.below(6));
    result.digest = random.bits();
    result.phenotype = random.bits();
    result.plan = random.bits();
    result.body_length = any_real(random);
    result.mass = any_real(random);
    result.parts = random.between(0, 100);
    result.neurons = random.between(0, 1'000);
    fill(result.behavior, random);
    result.computed_time = any_real(random);
    result.work = any_count(random);
    result.terminable = random.chance(0.5);
    for (std::size_t score = random.below(4); score > 0; --score)
        result.scores.push_back(any_real(random));
    if (random.chance(0.5)) result.reason = "too fast: \"\t\" \\ \xc3\xa9";
    result.verdict = static_cast<AuditVerdict>(random.below(3));
    fill(result.audit, random);
    if (random.chance(0.5))
        result.finer = FinerResult{static_cast<Outcome>(random.below(6)), any_real(random),
                                   static_cast<AuditVerdict>(random.below(3))};
    return result;
}

// Collects the fields one by one, independent of result_text().
std::vector<std::uint64_t> bits_of(const EvaluationResult& result) {
    std::vector<std::uint64_t> bits;
    const auto real = [&](double number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); };
    const auto whole = [&](auto number) { bits.push_back(static_cast<std::uint64_t>(number)); };
    real(result.fitness);
    whole(result.outcome);
    whole(result.digest);
    whole(result.phenotype);
    whole(result.plan);
    real(result.body_length);
    real(result.mass);
    whole(result.parts);
    whole(result.neurons);
    const Behavior& behavior = result.behavior;
    for (const double number :
         {behavior.settled_height, behavior.contact_share, behavior.joint_frequency,
          behavior.mean_joint_frequency, behavior.travel, behavior.stir})
        real(number);
    whole(behavior.movable_joints);
    real(result.computed_time);
    whole(result.work);
    whole(result.terminable);
    for (const double score : result.scores)
        real(score);
    for (const char letter : result.reason)
        whole(letter);
    whole(result.verdict);
    const SceneAudit& audit = result.audit;
    for (const double number :
         {audit.motor_work, audit.gross_motor_work, audit.drag_work, audit.contact_work,
          audit.limit_work, audit.impulse_work, audit.positive_work, audit.energy_residual,
          audit.energy_scale, audit.max_penetration, audit.max_limit_overrun, audit.max_part_speed,
          audit.max_part_spin})
        real(number);
    for (const std::uint64_t number :
         {audit.evaluations, audit.steps, audit.rejections, audit.events, audit.fallbacks})
        whole(number);
    whole(result.finer.has_value());
    if (result.finer) {
        whole(result.finer->outcome);
        real(result.finer->score);
        whole(result.finer->verdict);
    }
    return bits;
}

}  // namespace

TEST_CASE("a result's text keeps every bit of every field", "[cluster]") {
    RandomStream random(3);
    for (int i = 0; i < 300; ++i) {
        UnitResult unit{.worker = random.bits(), .deliveries = 2, .seconds = 0.25, .results = {}};
        for (std::uint32_t slot = 0; slot < 3; ++slot)
            unit.results.push_back({slot, random.bits(), any_result(random)});
        const Result<UnitResult> read = parse_unit_result(write_unit_result(unit));
        REQUIRE(read);
        CHECK(read->worker == unit.worker);
        CHECK(read->deliveries == 2);
        CHECK(read->seconds == 0.25);
        REQUIRE(read->results.size() == 3);
        for (std::size_t slot = 0; slot < 3; ++slot) {
            CHECK(read->results[slot].slot == slot);
            CHECK(read->results[slot].genome_hash == unit.results[slot].genome_hash);
            CHECK(bits_of(read->results[slot].result) == bits_of(unit.results[slot].result));
        }
        const EvaluationResult alone = unit.results.front().result;
        const Result<EvaluationResult> single = parse_result(result_text(alone));
        REQUIRE(single);
        CHECK(bits_of(*single) == bits_of(alone));
    }
}

TEST_CASE("results that differ in one bit of one field have different texts", "[cluster]") {
    RandomStream random(4);
    const EvaluationResult result = any_result(random);
    EvaluationResult other = result;
    CHECK(result_text(other) == result_text(result));
    other.audit.positive_work =
        std::bit_cast<double>(std::bit_cast<std::uint64_t>(other.audit.positive_work) ^ 1U);
    CHECK(result_text(other) != result_text(result));
    other = result;
    other.digest ^= std::uint64_t{1} << 63;
    CHECK(result_text(other) != result_text(result));
}

TEST_CASE("what is no result of a unit is refused with a reason", "[cluster]") {
    const std::string text = write_unit_result({});
    const auto message = [](const std::string& bad) {
        const Result<UnitResult> read = parse_unit_result(bad);
        return read ? std::string("read") : read.error().message;
    };
    CHECK(message(text) == "read");
    CHECK(message("[]").find("expected an object, found a list") != std::string::npos);
    CHECK(message("{}").find("/format: missing") != std::string::npos);
    UnitResult never;
    never.deliveries = 0;
    CHECK(message(write_unit_result(never)).find("/deliveries") != std::string::npos);
    std::string other = text;
    other.replace(other.find("result"), 6, "letter");
    CHECK(message(other).find("this is a \"cambrian-letter\"") != std::string::npos);
    std::string newer = text;
    newer.replace(newer.find("1,"), 2, "2,");
    CHECK(message(newer).find("expected 1, found 2") != std::string::npos);
    UnitResult wordy;
    wordy.results.resize(1);
    wordy.results[0].result.reason = std::string(401, 'x');
    CHECK(message(write_unit_result(wordy)).find("401 bytes, limit 400") != std::string::npos);
    CHECK(message(std::string(4'000'001, ' ')).find("E02") != std::string::npos);
}
