#pragma once

// Units as text: creatures to be evaluated with the same settings, and what a worker must know
// before it reads them. A unit is one line of JSON that describes it, followed by the deflated
// creature documents.

#include "core/deflated_text.h"
#include "core/result.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/creature/creature_format.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kMostUnitCreatures = 2'000;

// The conditions under which a unit is to be computed.
struct UnitTerms {
    std::uint64_t settings = 0;  // key of the settings
    std::string simulator;       // version that the coordinator runs
    std::uint64_t proof = 0;     // proof of the coordinator's build, see proof_set.h
    double deadline = 60.0;      // s, after which a worker stops computing it; positive

    friend bool operator==(const UnitTerms&, const UnitTerms&) = default;
};

// The requests' expected work is not sent, since results do not depend on it.
struct Unit {
    UnitTerms terms;
    std::vector<EvaluationRequest> requests;
};

class UnitWriter {
public:
    explicit UnitWriter(const EvolutionKinds& kinds);
    // Needs 1 to kMostUnitCreatures requests.
    std::string write(const UnitTerms& terms, std::span<const EvaluationRequest> requests);

private:
    creature_format::KindNames names_;
    std::string documents_;
    Deflater deflater_;
};

// The conditions only, for any version of the format; they tell whether the rest can be read.
struct UnitOutline {
    int version = 0;  // of the format
    UnitTerms terms;
};
inline constexpr int kUnitVersion = 1;
Result<UnitOutline> parse_unit_outline(std::string_view body);

class UnitReader {
public:
    explicit UnitReader(const EvolutionKinds& kinds) : kinds_(kinds) {}
    Result<Unit> read(std::string_view body);

private:
    const EvolutionKinds& kinds_;
    Inflater inflater_;
};

}  // namespace cambrian
