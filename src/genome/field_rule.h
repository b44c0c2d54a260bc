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

struct FieldRule {
    const char* name;    // in messages: "low limit"
    const char* key;     // in files, below its gene: "limits/0"
    double low;          // range, both ends included
    double high;         // excluded if the field wraps
    double fallback;     // value that replaces a number that is not finite
    bool wraps = false;  // reduced modulo the width of the range instead of reflected
    GeneStep step = {};
    double (*draw)(const FounderSettings& settings, RandomStream& stream) = nullptr;
    const char* unit = "";  // "m", "rad" or a plain number
    bool whole = false;     // only whole numbers are in range
    const char* help = "";  // what it means, where its gene's kind decides that
};

bool in_range(double x, const FieldRule& rule);

// Returns x if it is in range; otherwise x reflected or wrapped into it, and rounded where only
// whole numbers are in range, or the fallback if not finite.
double fit(double x, const FieldRule& rule);

// Returns x after one mutation step, inside the range.
double perturb(double x, const FieldRule& rule, const GeneStep& step, RandomStream& stream);

}  // namespace cambrian
