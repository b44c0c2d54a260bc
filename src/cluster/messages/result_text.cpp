#include "cluster/messages/result_text.h"

#include "cluster/messages/exact_real.h"
#include "cluster/messages/message_text.h"
#include "cluster/messages/unit_text.h"
#include "cluster/messages/work_queue.h"
#include "genome/gene_fields.h"
#include "persist/creature/creature_format.h"

#include <limits>
#include <numeric>

namespace cambrian {
namespace {

constexpr double kMostExact = 9007199254740992.0;  // 2^53; integers up to it are exact
constexpr double kMostCount = 1e9;
constexpr std::size_t kMostScores = 128;
const MessageKind kResultKind{"cambrian-result", 1};
const MessageKind kOneKind{"cambrian-one-result", 1};
const std::vector<std::string> kOutcomes =
    creature_format::names_to(Outcome::kInterrupted, outcome_name);

constexpr FieldRule kSeconds{.name = "seconds",
                             .key = "seconds",
                             .low = 0.0,
                             .high = std::numeric_limits<double>::max(),
                             .fallback = 0.0};

template <class Archive, class Described>
void describe_behavior(Archive& archive, Described& behavior) {
    exact_real(archive, "height", behavior.settled_height);
    exact_real(archive, "contact", behavior.contact_share);
    exact_real(archive, "frequency", behavior.joint_frequency);
    exact_real(archive, "meanFrequency", behavior.mean_joint_frequency);
    exact_real(archive, "travel", behavior.travel);
    exact_real(archive, "stir", behavior.stir);
    archive.integer("joints", behavior.movable_joints, -kMostCount, kMostCount);
}

template <class Archive, class Described>
void describe_audit(Archive& archive, Described& audit) {
    exact_real(archive, "motor", audit.motor_work);
    exact_real(archive, "grossMotor", audit.gross_motor_work);
    exact_real(archive, "drag", audit.drag_work);
    exact_real(archive, "contact", audit.contact_work);
    exact_real(archive, "limit", audit.limit_work);
    exact_real(archive, "impulse", audit.impulse_work);
    exact_real(archive, "positive", audit.positive_work);
    exact_real(archive, "residual", audit.energy_residual);
    exact_real(archive, "scale", audit.energy_scale);
    exact_real(archive, "penetration", audit.max_penetration);
    exact_real(archive, "overrun", audit.max_limit_overrun);
    exact_real(archive, "speed", audit.max_part_speed);
    exact_real(archive, "spin", audit.max_part_spin);
    archive.integer("evaluations", audit.evaluations, 0.0, kMostExact);
    archive.integer("steps", audit.steps, 0.0, kMostExact);
    archive.integer("rejections", audit.rejections, 0.0, kMostExact);
    archive.integer("events", audit.events, 0.0, kMostExact);
    archive.integer("fallbacks", audit.fallbacks, 0.0, kMostExact);
}

// Describes a list of numbers as a list of objects, because JSON has no infinities and no NaN.
template <class Archive, class Scores>
void describe_scores(Archive& archive, Scores& scores) {
    archive.list("scores", scores, 0, kMostScores, JsonLayout::kCompact,
                 [](Archive& inner, auto& score) { exact_real(inner, "score", score); });
}

template <class Archive, class Described>
void describe_result(Archive& archive, Described& result) {
    exact_real(archive, "fitness", result.fitness);
    archive.choice("outcome", result.outcome, kOutcomes, "outcome");
    archive.digest("digest", result.digest);
    archive.digest("phenotype", result.phenotype);
    archive.digest("plan", result.plan);
    exact_real(archive, "length", result.body_length);
    exact_real(archive, "mass", result.mass);
    archive.integer("parts", result.parts, -kMostCount, kMostCount);
    archive.integer("neurons", result.neurons, -kMostCount, kMostCount);
    archive.object("behavior", JsonLayout::kCompact,
                   [&](Archive& inner) { describe_behavior(inner, result.behavior); });
    exact_real(archive, "time", result.computed_time);
    archive.integer("work", result.work, 0.0, kMostExact);
    archive.flag("hopeless", result.terminable);
    describe_scores(archive, result.scores);
    archive.text("reason", result.reason, kLongestResultReason);
    archive.choice("verdict", result.verdict, creature_format::kVerdicts, "verdict");
    archive.object("audit", JsonLayout::kCompact,
                   [&](Archive& inner) { describe_audit(inner, result.audit); });
    archive.optional_object(
        "finer", result.finer, JsonLayout::kCompact, [](Archive& inner, auto& finer) {
            inner.choice("outcome", finer.outcome, kOutcomes, "outcome");
            exact_real(inner, "score", finer.score);
            inner.choice("verdict", finer.verdict, creature_format::kVerdicts, "verdict");
        });
}

template <class Archive, class Described>
void describe_unit_result(Archive& archive, Described& unit) {
    archive.digest("worker", unit.worker);
    archive.integer("deliveries", unit.deliveries, 1.0, kMostCount);
    archive.real("seconds", unit.seconds, kSeconds);
    archive.list("results", unit.results, 0, kMostUnitCreatures, JsonLayout::kCompact,
                 [](Archive& inner, auto& each) {
                     inner.integer("slot", each.slot, 0.0, kMostSlot);
                     inner.digest("genome", each.genome_hash);
                     describe_result(inner, each.result);
                 });
}

}  // namespace

std::uint64_t total_work(std::span<const SlotResult> results) {
    return std::accumulate(
        results.begin(), results.end(), std::uint64_t{0},
        [](std::uint64_t sum, const SlotResult& each) { return sum + each.result.work; });
}

std::string write_unit_result(const UnitResult& result) {
    return write_message(kResultKind, result, [](JsonWriter& writer, const UnitResult& each) {
        describe_unit_result(writer, each);
    });
}

Result<UnitResult> parse_unit_result(std::string_view text) {
    constexpr JsonLimits kResultLimits{
        .bytes = kMostResultBytes, .depth = 6, .values = 80 * kMostUnitCreatures, .keys = 64};
    return read_message<UnitResult>(
        kResultKind, text, kResultLimits,
        [](JsonReader& reader, UnitResult& each) { describe_unit_result(reader, each); });
}

std::string result_text(const EvaluationResult& result) {
    return write_message(kOneKind, result, [](JsonWriter& writer, const EvaluationResult& each) {
        describe_result(writer, each);
    });
}

Result<EvaluationResult> parse_result(std::string_view text) {
    constexpr JsonLimits kOneResultLimits{
        .bytes = kMostResultBytes, .depth = 5, .values = 80 + kMostScores, .keys = 64};
    return read_message<EvaluationResult>(
        kOneKind, text, kOneResultLimits,
        [](JsonReader& reader, EvaluationResult& each) { describe_result(reader, each); });
}

bool same_result(const EvaluationResult& a, const EvaluationResult& b) {
    return result_text(a) == result_text(b);
}

}  // namespace cambrian
