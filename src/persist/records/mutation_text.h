#pragma once

// Mutation records as one short text: a JSON list of [operator, place, from, to].

#include "breeding/mutation_kind.h"
#include "core/result.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kLongestMutations = 100'000;  // bytes

// Returns nothing if there are no mutations.
std::optional<std::string> mutations_text(std::span<const MutationRecord> mutations);
Result<std::vector<MutationRecord>> parse_mutations(std::string_view text);

}  // namespace cambrian
