#include "genome/field_rule.h"

#include "math/elementary.h"
#include "math/reflect.h"

#include <cmath>

namespace cambrian {

bool in_range(double x, const FieldRule& rule) {
    if (rule.whole && x != std::floor(x)) return false;
    return x >= rule.low && (rule.wraps ? x < rule.high : x <= rule.high);
}

double fit(double x, const FieldRule& rule) {
    if (!std::isfinite(x)) return rule.fallback;
    if (in_range(x, rule)) return x;
    if (!rule.wraps) {
        const double inside = reflect(x, rule.low, rule.high);
        return rule.whole ? std::floor(inside + 0.5) : inside;
    }
    const double width = rule.high - rule.low;
    const double wrapped = x - width * std::floor((x - rule.low) / width);
    return in_range(wrapped, rule) ? wrapped : rule.low;
}

double draw(const FieldRule& rule, const FounderSettings& settings, RandomStream& stream) {
    const FounderDraw& founders = rule.founders;
    if (founders.least != nullptr) {
        const double least = settings.*founders.least;
        return least * power(settings.*founders.most / least, stream.uniform());
    }
    if (founders.fallback_share > 0.0 && stream.chance(founders.fallback_share))
        return rule.fallback;
    const double drawn = stream.uniform(founders.low, founders.high);
    return founders.negated ? -drawn : drawn;
}

double perturb(double x, const FieldRule& rule, const GeneStep& step, RandomStream& stream) {
    const double gauss = stream.gauss();
    const double factor = stream.chance(step.long_share) ? step.long_factor : 1.0;
    return fit(x + gauss * factor * step.relative * std::fmax(std::fabs(x), step.floor), rule);
}

}  // namespace cambrian
