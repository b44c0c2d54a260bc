#pragma once

#include "core/result.h"
#include "persist/settings/challenge_file.h"
#include "persist/settings/toml.h"

#include <optional>
#include <string_view>

namespace cambrian {

// Takes the table [challenge] out of a document, if there is one. Fails if it is not as a challenge
// has it, or if it was frozen with another version of the simulator of so many dimensions; `source`
// is named.
Result<std::optional<ChallengeTable>> take_challenge(toml::table& document, std::string_view source,
                                                     int dimensions);

}  // namespace cambrian
