#pragma once

// A table of the kinds that genes may use, filled from the registries of the layers that own them,
// in the order of registration. Genes store indices into it, which digests of genes include; files
// store the ids.

#include "genome/field_rule.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

// The distribution of a founder's constant input, for inputs that are useful only in a range, such
// as an oscillator's frequency. With the probability, the input is a constant, uniform in [low,
// high].
struct FounderConstant {
    double probability = 0.0;
    double low = 0.0;
    double high = 0.0;
};

struct FunctionEntry {
    std::string id;
    std::string label;
    int arity = 1;                                // 1 to 3
    std::vector<FounderConstant> founder_inputs;  // one per input, or empty
};

struct JointChoice {
    std::string id;
    std::string label;
    int degrees_of_freedom = 0;
    bool usual = true;  // enabled by default
};

struct ChannelEntry {
    std::string id;  // "joint", "contact-distal", ...
    std::string label;
    bool usual = true;       // enabled by default
    std::string group = {};  // label of the senses that it belongs to
};

struct EffectorEntry {
    std::string id;  // "joint", ...
    std::string label;
};

struct OrganEntry {
    std::string id;  // "sound", ...
    std::string label;
    std::vector<FieldRule> parameters;  // at most gene_range::kMaxOrganParameters
    bool usual = false;                 // enabled by default
    bool single = false;                // a part has at most one of this kind
};

// The entry of KindCatalog::reproductions that leaves the breeding method to the settings.
inline constexpr std::uint8_t kNoOwnMethod = 0;

struct KindCatalog {
    int dimensions = 2;  // of the genomes that use the kinds
    std::vector<FunctionEntry> functions;
    std::vector<JointChoice> joints;
    std::vector<EffectorEntry> effectors;
    std::vector<OrganEntry> organs;
    std::vector<ChannelEntry> channels;  // indexed by channel number
    // "inherit", then the ids of the breeding methods that genes may name.
    std::vector<std::string> reproductions = {"inherit"};
};

}  // namespace cambrian
