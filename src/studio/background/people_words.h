#pragma once

#include <string>

namespace cambrian {

// Returns a message about a file or a genotype in words for people: without the codes of faults and
// warnings ("E01 "), and with the places of genes as the inspector names them: "part 0 length" for
// "/nodes/0/length".
std::string people_words(const std::string& message);

}  // namespace cambrian
