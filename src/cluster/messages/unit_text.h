#pragma once

// Units as text: creatures to be evaluated under one settings, with what a worker must know before
// it reads on. A unit is one line of JSON that describes it and, after the line's end, the deflated
// creature documents, one after the other.

#include "core/result.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/creature/creature_format.h"
#include "persist/text/deflated_text.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kMostUnitCreatures = 2'000;

// What a unit says of itself.
struct UnitTerms {
    std::uint64_t settings = 0;  // key of the settings
    std::string simulator;       // version that the coordinator runs
    std::uint64_t proof = 0;     // of the coordinator's build, proof_set.h
    double deadline = 60.0;      // s, after which a worker gives up; above 0

    friend bool operator==(const UnitTerms&, const UnitTerms&) = default;
};

// The requests' expected work does not travel: no result depends on it.
struct Unit {
    UnitTerms terms;
    std::vector<EvaluationRequest> requests;
};

class UnitWriter {
public:
    explicit UnitWriter(const EvolutionKinds& kinds);
    // 1 to kMostUnitCreatures requests.
    std::string write(const UnitTerms& terms, std::span<const EvaluationRequest> requests);

private:
    creature_format::KindNames names_;
    std::string documents_;
    Deflater deflater_;
};

// Only the terms, of whatever version of the format: enough to know whether to read on.
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
