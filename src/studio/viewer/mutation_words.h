#pragma once

// Mutations as people read them.

#include "breeding/mutation_kind.h"

#include <string>

namespace cambrian {

// "Length or limit", "Edited by hand".
std::string operator_words(const MutationRecord& mutation, const MutationRegistry& kinds);
// "0.5 → 0.62"; one of the two where there is no other.
std::string change_words(const MutationRecord& mutation);

// "Length or limit: part 2 length 0.4 → 0.5"
std::string mutation_words(const MutationRecord& mutation, const MutationRegistry& kinds);

// Operator, place and change, in lines that break between words alone.
void draw_mutation(const MutationRecord& mutation, const MutationRegistry& kinds);

}  // namespace cambrian
