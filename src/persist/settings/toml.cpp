#include "persist/settings/toml.h"

namespace cambrian {

toml::parse_result parse_toml(std::string_view text) {
    return toml::parse(text);
}

}  // namespace cambrian
