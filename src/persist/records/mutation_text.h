#pragma once

// Mutation records as one short text: a JSON list of [operator, place, from, to].

#include "breeding/mutation_kind.h"
#include "core/result.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Returns nothing if there are no mutations.
std::optional<std::string> mutations_text(std::span<const MutationRecord> mutations);
Result<std::vector<MutationRecord>> parse_mutations(std::string_view text);

}  // namespace cambrian
