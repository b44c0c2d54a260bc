#pragma once

// Descriptions of mutations.

#include "breeding/mutation_kind.h"

#include <string>

namespace cambrian {

// Examples: "Length or limit", "Edited by hand".
std::string operator_words(const MutationRecord& mutation, const MutationRegistry& kinds);
// Example: "0.5 → 0.62". If only one of the two values exists, it is that value.
std::string change_words(const MutationRecord& mutation);

// Example: "Length or limit: part 2 length 0.4 → 0.5".
std::string mutation_words(const MutationRecord& mutation, const MutationRegistry& kinds);

// Draws operator, place and change; lines break only between words.
void draw_mutation(const MutationRecord& mutation, const MutationRegistry& kinds);

}  // namespace cambrian
