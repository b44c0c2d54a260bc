#pragma once

// Genes and numbers as short text, for messages and mutation records.

#include "genome/gene.h"
#include "genome/kind_catalog.h"

#include <string>

namespace cambrian {

// Formats with at most four significant digits, identical on every machine: "0.62", "-1.571",
// "1e-05".
std::string in_words(double number);

// Examples: "constant", "local neuron 3", "parent sensor contact-left", "part 2 instance 0 neuron
// 1".
std::string in_words(const SourceRef& source, const KindCatalog& catalog);

}  // namespace cambrian
