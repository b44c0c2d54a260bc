#include "app/trial/trial_report.h"

#include "core/sample_statistics.h"
#include "core/text/number_text.h"
#include "persist/json/json_text.h"
#include "persist/text/digest_text.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

// Formats with three significant digits.
std::string rounded(double number) {
    return fmt::format("{:.3g}", number);
}

std::string percent_of(double number, double whole) {
    return whole > 0.0 ? fmt::format(" ({} %)", rounded(100.0 * number / whole)) : "";
}

std::string audit_json(const SceneAudit& audit) {
    return json_object({{"motor_work", real_text(audit.motor_work)},
                        {"gross_motor_work", real_text(audit.gross_motor_work)},
                        {"drag_work", real_text(audit.drag_work)},
                        {"contact_work", real_text(audit.contact_work)},
                        {"limit_work", real_text(audit.limit_work)},
                        {"impulse_work", real_text(audit.impulse_work)},
                        {"positive_work", real_text(audit.positive_work)},
                        {"energy_residual", real_text(audit.energy_residual)},
                        {"energy_scale", real_text(audit.energy_scale)},
                        {"spin_gained", real_text(audit.spin_gained)},
                        {"spin_scale", real_text(audit.spin_scale)},
                        {"max_penetration", real_text(audit.max_penetration)},
                        {"max_limit_overrun", real_text(audit.max_limit_overrun)},
                        {"max_part_speed", real_text(audit.max_part_speed)},
                        {"max_part_spin", real_text(audit.max_part_spin)},
                        {"evaluations", std::to_string(audit.evaluations)},
                        {"steps", std::to_string(audit.steps)},
                        {"rejections", std::to_string(audit.rejections)},
                        {"events", std::to_string(audit.events)},
                        {"fallbacks", std::to_string(audit.fallbacks)}});
}

std::string audit_text(const SceneAudit& audit) {
    return fmt::format(
        "muscles worked {} J; unexplained {} J{}, gained from contacts and limits {} J{}, spin "
        "gained from nothing {} kg m^2/s{}\ndeepest "
        "penetration {} mm, largest limit violation {} rad, fastest part {} m/s, fastest spin {} "
        "rad/s\n{} evaluations, {} steps, {} rejections, {} impacts, {} fallbacks",
        rounded(audit.gross_motor_work), rounded(audit.energy_residual),
        percent_of(audit.energy_residual, audit.energy_scale), rounded(audit.positive_work),
        percent_of(audit.positive_work, audit.energy_scale), rounded(audit.spin_gained),
        percent_of(audit.spin_gained, audit.spin_scale), rounded(1e3 * audit.max_penetration),
        rounded(audit.max_limit_overrun), rounded(audit.max_part_speed),
        rounded(audit.max_part_spin), audit.evaluations, audit.steps, audit.rejections,
        audit.events, audit.fallbacks);
}

// Example: "in 10 slightly different worlds: 0.93 BL/s, 0.81 to 0.99".
std::string scores_text(const std::vector<double>& scores, const std::string& unit) {
    const auto range = std::minmax_element(scores.begin(), scores.end());
    return fmt::format("in {} slightly different worlds: median {} {}, {} to {}", scores.size(),
                       rounded(median(scores)), unit, rounded(*range.first),
                       rounded(*range.second));
}

std::string scores_json(const std::vector<double>& scores) {
    std::vector<std::string> values;
    values.reserve(scores.size());
    for (const double score : scores)
        values.push_back(real_text(score));
    return json_list(values);
}

}  // namespace

std::string finer_text(const FinerResult& finer, const std::string& unit) {
    const std::string came_to = finer.outcome == Outcome::kCompleted
                                    ? fmt::format("{} {}", short_text(finer.score), unit)
                                    : std::string(outcome_name(finer.outcome));
    return fmt::format("{}, {}", came_to, verdict_name(finer.verdict));
}

std::string trial_text(const EvaluationResult& result, const std::string& unit) {
    std::string text(outcome_name(result.outcome));
    if (!result.reason.empty()) text += fmt::format(" ({})", result.reason);
    text += fmt::format(
        ": {} {}\n{} parts, {} connected neurons, {} m long, {} kg\nmotion {}\naudit: {}; {}",
        short_text(result.fitness), unit, result.parts, result.neurons,
        short_text(result.body_length), short_text(result.mass), digest_text(result.digest),
        verdict_name(result.verdict), audit_text(result.audit));
    if (!result.scores.empty()) text += "\n" + scores_text(result.scores, unit);
    if (result.finer) text += "\ncomputed more finely: " + finer_text(*result.finer, unit);
    return text;
}

std::string trial_json(const EvaluationResult& result, const std::string& unit,
                       const std::string& senses) {
    const std::string finer =
        result.finer ? json_object({{"outcome", quoted_text(outcome_name(result.finer->outcome))},
                                    {"fitness", real_text(result.finer->score)},
                                    {"verdict", quoted_text(verdict_name(result.finer->verdict))}})
                     : "null";
    return json_object({{"outcome", quoted_text(outcome_name(result.outcome))},
                        {"reason", quoted_text(result.reason)},
                        {"fitness", real_text(result.fitness)},
                        {"unit", quoted_text(unit)},
                        {"body_length", real_text(result.body_length)},
                        {"mass", real_text(result.mass)},
                        {"parts", std::to_string(result.parts)},
                        {"neurons", std::to_string(result.neurons)},
                        {"trajectory", quoted_text(digest_text(result.digest))},
                        {"verdict", quoted_text(verdict_name(result.verdict))},
                        {"audit", audit_json(result.audit)},
                        {"repeated", scores_json(result.scores)},
                        {"recomputed", finer},
                        {"senses", senses}});
}

}  // namespace cambrian
