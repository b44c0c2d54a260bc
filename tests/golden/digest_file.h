#pragma once

#include "core/result.h"
#include "golden/golden.h"

#include <filesystem>

namespace cambrian::golden {

// Writes one line per digest: its name and 16 hexadecimal digits.
std::string text_of(const Digests& digests);

// Returns one line for each difference between the recorded text and the digests: different values,
// missing records, and unknown records.
std::vector<std::string> differences(const std::string& recorded, const Digests& digests);

}  // namespace cambrian::golden
