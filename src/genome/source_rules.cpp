#include "genome/source_rules.h"

#include "core/assert.h"

#include <array>

namespace cambrian {
namespace {

constexpr SourceReads kNeuron = SourceReads::kNeuron;
constexpr SourceReads kSensor = SourceReads::kSensor;

// In the order of SourceKind. The columns are id, label, reads, in parts, in brain, child,
// instance.
constexpr std::array<SourceRule, kSourceKindCount> kRules = {{
    {"const", "Constant", SourceReads::kConstant, true, true, false, false},
    {"localNeuron", "Neuron of the same part", kNeuron, true, false, false, false},
    {"localSensor", "Sensor of the same part", kSensor, true, false, false, false},
    {"parentNeuron", "Neuron of the parent", kNeuron, true, false, false, false},
    {"parentSensor", "Sensor of the parent", kSensor, true, false, false, false},
    {"childNeuron", "Neuron of a child", kNeuron, true, false, true, false},
    {"childSensor", "Sensor of a child", kSensor, true, false, true, false},
    {"brainNeuron", "Central neuron", kNeuron, true, true, false, false},
    {"partNeuron", "Neuron of any part", kNeuron, false, true, false, true},
    {"partSensor", "Sensor of any part", kSensor, false, true, false, true},
}};

std::uint8_t in_reference_range(std::uint8_t number) {
    return static_cast<std::uint8_t>(number % (gene_range::kMaxReference + 1));
}

}  // namespace

std::span<const SourceRule, kSourceKindCount> source_rules() {
    return kRules;
}

SourceRule source_rule(SourceKind kind) {
    CAMBRIAN_ASSERT(is_known(kind), "a known kind of source");
    return kRules[static_cast<std::size_t>(kind)];
}

bool is_allowed(SourceKind kind, SourceScope scope) {
    if (!is_known(kind)) return false;
    const SourceRule rule = source_rule(kind);
    return scope == SourceScope::kPart ? rule.in_parts : rule.in_brain;
}

SourceRef canonical(const SourceRef& source, SourceScope scope) {
    SourceRef result;
    if (!is_allowed(source.kind, scope)) return result;
    const SourceRule rule = source_rule(source.kind);
    result.kind = source.kind;
    if (rule.reads == kSensor) result.index = source.index;
    if (rule.reads == kNeuron) result.index = in_reference_range(source.index);
    if (rule.uses_child) result.child = in_reference_range(source.child);
    if (rule.uses_instance) {
        result.node = in_reference_range(source.node);
        result.instance = in_reference_range(source.instance);
    }
    return result;
}

SourceRef own_neuron(SourceScope scope, std::size_t neuron) {
    CAMBRIAN_ASSERT(neuron <= gene_range::kMaxReference, "a neuron a reference can name");
    return {.kind = own_neuron_kind(scope), .index = static_cast<std::uint8_t>(neuron)};
}

}  // namespace cambrian
