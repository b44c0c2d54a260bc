#pragma once

// The rule of a scalar gene: its range, its mutation step and its distribution in founders.

#include "core/random.h"
#include "genome/founder_settings.h"

namespace cambrian {

// A perturbation adds gauss() * m * relative * max(|x|, floor), where m is long_factor with
// probability long_share, else 1 (genome/README.md 5).
struct GeneStep {
    double relative = 0.2;
    double floor = 0.1;
    double long_factor = 4.0;
    double long_share = 0.15;
};

// The distribution of a number in founders (genome/README.md 4): the rule's fallback for a share of
// them, otherwise uniform in [low, high) or, where settings bound it, log-uniform between those.
struct FounderDraw {
    double low = 0.0;
    double high = 1.0;
    double fallback_share = 0.0;
    bool negated = false;  // the drawn number's negative is taken
    double FounderSettings::*least = nullptr;
    double FounderSettings::*most = nullptr;
};

struct FieldRule {
    const char* name = "";  // in messages: "low limit"
    const char* key = "";   // in files, below its gene: "limits/0"
    double low = 0.0;       // range, both ends included
    double high = 0.0;      // excluded if the field wraps
    double fallback = 0.0;  // value that replaces a number that is not finite
    bool wraps = false;     // reduced modulo the width of the range instead of reflected
    GeneStep step = {};
    FounderDraw founders = {};
    const char* unit = "";  // "m", "rad" or a plain number
    bool whole = false;     // only whole numbers are in range
    const char* help = "";  // what it means, a sentence
};

bool in_range(double x, const FieldRule& rule);

// Returns x if it is in range; otherwise x reflected or wrapped into it, and rounded where only
// whole numbers are in range, or the fallback if not finite.
double fit(double x, const FieldRule& rule);

// Returns a number as founders have it; it may be out of range.
double draw(const FieldRule& rule, const FounderSettings& settings, RandomStream& stream);

// Returns x after one mutation step, inside the range.
double perturb(double x, const FieldRule& rule, const GeneStep& step, RandomStream& stream);

}  // namespace cambrian
