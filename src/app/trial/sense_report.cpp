#include "app/trial/sense_report.h"

#include "core/text/number_text.h"
#include "persist/json/json_text.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

// Example: "0.21 BL/s (23 % of 0.92)".
std::string left_text(double left, double intact, const std::string& unit) {
    std::string text = fmt::format("{:.3g} {}", left, unit);
    if (intact > 0.0)
        text += fmt::format(" ({:.0f} % of {:.3g})", 100.0 * std::max(0.0, left) / intact, intact);
    return text;
}

}  // namespace

std::string senses_text(const SenseLosses& losses, const std::string& unit) {
    if (losses.each.empty()) return "senses: the brain hears none";
    std::string text = "senses: " + left_text(losses.without_all, losses.intact, unit) +
                       " is left if each reads its best constant";
    std::vector<SenseLoss> sorted = losses.each;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const SenseLoss& a, const SenseLoss& b) { return a.score < b.score; });
    for (const SenseLoss& loss : sorted)
        text += fmt::format("\n  {} of part {} at {:.3g}: {}", loss.channel, loss.part,
                            loss.constant, left_text(loss.score, losses.intact, unit));
    return text;
}

std::string senses_json(const SenseLosses& losses) {
    std::vector<std::string> each;
    for (const SenseLoss& loss : losses.each)
        each.push_back(json_object({{"sensor", quoted_text(loss.channel)},
                                    {"part", std::to_string(loss.part)},
                                    {"constant", real_text(loss.constant)},
                                    {"fitness", real_text(loss.score)}}));
    return json_object({{"intact", real_text(losses.intact)},
                        {"without_all", real_text(losses.without_all)},
                        {"each", json_list(each)}});
}

}  // namespace cambrian
