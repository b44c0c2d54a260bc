#pragma once

// A mutation operator (breeding/README.md 3) and the registry of them.

#include "core/random.h"
#include "core/registry.h"
#include "genome/founder_settings.h"
#include "genome/genome.h"

#include <cstdint>
#include <string>

namespace cambrian {

// The order in which operators are applied to one offspring.
enum class MutationPhase : std::uint8_t { kParameters, kGrowth, kConnections };

// The genes that an operator changes: parts with their joints and attachments, or neurons,
// references and organs.
enum class MutationSubject : std::uint8_t { kBody, kBrain };

// The context of an operator besides the genome.
struct MutationContext {
    const KindCatalog& catalog;
    const FounderSettings& founders;  // enabled kinds, ranges of new genes
    bool mutate_reproduction = false;
};

// The description of one change: the operator, the place, the old and the new value.
struct MutationRecord {
    std::string operator_id;
    std::string place;  // "part 2 length", "part 1 neuron 0 input 1"
    std::string from;
    std::string to;
};

struct MutationKind {
    std::string id;
    std::string label;
    MutationPhase phase = MutationPhase::kParameters;
    MutationSubject subject = MutationSubject::kBody;
    double default_weight = 1.0;
    // Changes the genome at one place and describes the change. Returns false if it cannot be
    // applied here. The genome is repaired afterwards.
    bool (*apply)(Genome& genome, const MutationContext& context, RandomStream& stream,
                  MutationRecord& record) = nullptr;
    // Returns whether the operator may be drawn; null means always. Otherwise its weight is 0.
    bool (*enabled)(const MutationContext& context) = nullptr;
    // Younger than settings files that do not name it (SettingField::later).
    bool later = false;
};

using MutationRegistry = Registry<MutationKind>;

MutationRegistry builtin_mutations();

}  // namespace cambrian
