#pragma once

#include "core/result.h"
#include "golden/golden.h"

#include <filesystem>

namespace cambrian::golden {

// A line a digest: its name and 16 hexadecimal digits.
std::string text_of(const Digests& digests);

// What of the recorded text is not as computed here, a line each: digests that differ, that are
// missing from the record, or that are recorded and unknown.
std::vector<std::string> differences(const std::string& recorded, const Digests& digests);

}  // namespace cambrian::golden
