#include "persist/settings/toml.h"

#include "persist/settings/toml_nesting.h"

#include <fmt/core.h>

#include <string>
#include <utility>

namespace cambrian {
namespace {

toml::parse_result toml_error(std::string&& reason, std::size_t line) {
    const auto number = static_cast<toml::source_index>(line);
    return toml::parse_result(
        toml::parse_error(std::move(reason), toml::source_position{number, 1}));
}

}  // namespace

toml::parse_result parse_toml(std::string_view text) {
    if (text.size() > kLargestToml)
        return toml_error(
            fmt::format("the text has {} bytes, at most {} are read", text.size(), kLargestToml),
            1);
    if (const std::size_t line = line_nested_too_deeply(text); line > 0)
        return toml_error(fmt::format("nested deeper than {} levels", kDeepestToml), line);
    return toml::parse(text);
}

}  // namespace cambrian
