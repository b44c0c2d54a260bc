#pragma once

// For each kind of SourceRef: what it reads, which of its fields are used and where it is allowed
// (genome/README.md 2).

#include "genome/gene.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace cambrian {

// The reader of a reference: neurons and effector of a part, or neurons of the central brain.
enum class SourceScope : std::uint8_t { kPart, kBrain };

enum class SourceReads : std::uint8_t { kConstant, kNeuron, kSensor };

struct SourceRule {
    std::string_view id;  // in files
    std::string_view label;
    SourceReads reads = SourceReads::kConstant;
    bool in_parts = true;
    bool in_brain = true;
    bool uses_child = false;
    bool uses_instance = false;  // uses the fields node and instance
};

inline constexpr int kSourceKindCount = 10;

inline bool is_known(SourceKind kind) {
    return static_cast<int>(kind) < kSourceKindCount;
}

// In the order of SourceKind.
std::span<const SourceRule, kSourceKindCount> source_rules();

// Returns the rule of a known kind.
SourceRule source_rule(SourceKind kind);

bool is_allowed(SourceKind kind, SourceScope scope);

// Returns the reference in canonical form. Unused fields are 0, the others from 0 to 15 (channels
// keep their number). Kinds that are unknown or not allowed in the scope become constants.
SourceRef canonical(const SourceRef& source, SourceScope scope);

// Returns the reference to a neuron from within its own list.
SourceRef own_neuron(SourceScope scope, std::size_t neuron);
inline SourceKind own_neuron_kind(SourceScope scope) {
    return scope == SourceScope::kPart ? SourceKind::kLocalNeuron : SourceKind::kBrainNeuron;
}

}  // namespace cambrian
