#pragma once

#include <map>
#include <string>

namespace cambrian {

// The settings of the mutation of offspring (breeding/README.md 1).
struct MutationSettings {
    std::string scheme = "count-first";  // "count-first", "gate" or "none"
    // Scales the number of mutations; 1 gives none, one and more in exactly 25, 50 and 25 % of the
    // children. Each unit of the rate draws the scheme's count once; a fraction is the probability
    // of one more draw.
    double rate = 1.0;
    // Relative weight of each operator by id; operators not named keep their default weight.
    std::map<std::string, double> weights = {};
    // Whether disconnected neurons are removed. They are kept by default, because they cost nothing
    // and a later mutation may connect them.
    bool remove_disconnected_neurons = false;

    // Whether offspring mutate at all.
    bool mutates() const { return scheme != "none" && rate > 0.0; }

    friend bool operator==(const MutationSettings&, const MutationSettings&) = default;
};

}  // namespace cambrian
