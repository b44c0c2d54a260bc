#pragma once

// Returns the message of the settings reader for a text.

#include "persist/settings/settings_file.h"
#include "support/kinds.h"

#include <string>
#include <string_view>

namespace cambrian::test {

inline std::string message_of(std::string_view text) {
    const auto loaded = parse_settings(text, "run.toml", kinds());
    return loaded ? "no error" : loaded.error().message;
}

}  // namespace cambrian::test
