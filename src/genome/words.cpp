#include "genome/words.h"

#include "genome/source_rules.h"

#include <fmt/core.h>

#include <array>
#include <charconv>

namespace cambrian {
namespace {

std::string owner_in_words(const SourceRef& source) {
    switch (source.kind) {
        case SourceKind::kParentNeuron:
        case SourceKind::kParentSensor:
            return "parent ";
        case SourceKind::kChildNeuron:
        case SourceKind::kChildSensor:
            return fmt::format("child {} ", source.child);
        case SourceKind::kBrainNeuron:
            return "brain ";
        case SourceKind::kPartNeuron:
        case SourceKind::kPartSensor:
            return fmt::format("part {} instance {} ", source.node, source.instance);
        default:
            return "local ";
    }
}

}  // namespace

std::string in_words(double number) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 4)
            .ptr;
    return {text.data(), end};
}

std::string in_words(const SourceRef& source, const KindCatalog& catalog) {
    const SourceRule rule = source_rule(source.kind);
    if (rule.reads == SourceReads::kConstant) return "constant";
    if (rule.reads == SourceReads::kNeuron) {
        return fmt::format("{}neuron {}", owner_in_words(source), source.index);
    }
    const bool known = source.index < catalog.channels.size();
    return fmt::format("{}sensor {}", owner_in_words(source),
                       known ? catalog.channels[source.index].id : std::to_string(source.index));
}

}  // namespace cambrian
