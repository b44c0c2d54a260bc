#pragma once

// A plain table of the kinds genes may use, filled from the registries of the layers that own them,
// in registration order. Genes store indices into it, and digests of genes count them; files store
// the ids.

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

// What a founder's constant input is drawn from, for inputs that only make sense in a range (an
// oscillator's frequency, say): with the probability, a constant uniform in [low, high].
struct FounderConstant {
    double probability = 0.0;
    double low = 0.0;
    double high = 0.0;
};

struct FunctionEntry {
    std::string id;
    std::string label;
    int arity = 1;                                // 1 to 3
    std::vector<FounderConstant> founder_inputs;  // one an input, or empty
};

struct JointChoice {
    std::string id;
    std::string label;
    int degrees_of_freedom = 0;
    bool usual = true;  // whether it is used unless settings say otherwise
};

struct ChannelEntry {
    std::string id;  // "joint", "contact-distal", ...
    std::string label;
    bool usual = true;  // whether it is used unless settings say otherwise
};

struct EffectorEntry {
    std::string id;  // "joint", ...
    std::string label;
};

// The entry of KindCatalog::reproductions that leaves the breeding method to the settings.
inline constexpr std::uint8_t kNoOwnMethod = 0;

struct KindCatalog {
    std::vector<FunctionEntry> functions;
    std::vector<JointChoice> joints;
    std::vector<EffectorEntry> effectors;
    std::vector<ChannelEntry> channels;  // absolute channel numbers
    // "inherit", then the ids of the breeding methods that genes may name.
    std::vector<std::string> reproductions = {"inherit"};
};

}  // namespace cambrian
