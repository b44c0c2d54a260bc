#include "studio/widgets/typed_number.h"

#include "core/text/parsed_number.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace cambrian {
namespace {

constexpr std::string_view kMinus = "−";
constexpr std::size_t kGroup = 3;  // digits between the commas of "1,500"

std::string_view without_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

Result<double> typed_number(std::string_view text, std::string_view unit) {
    const std::string typed(without_blanks(text));
    std::string_view number = typed;
    if (!unit.empty() && number.ends_with(unit))
        number = without_blanks(number.substr(0, number.size() - unit.size()));
    std::string plain;
    if (number.starts_with(kMinus)) {
        plain = "-";
        number.remove_prefix(kMinus.size());
    } else if (number.starts_with('+')) {
        number.remove_prefix(1);
    }
    plain += number;
    const std::size_t comma = plain.find(',');
    if (comma != std::string::npos) {
        const std::string_view after = std::string_view(plain).substr(comma + 1);
        if (after.size() == kGroup && plain.find_first_not_of("-0") < comma) {
            return Error{fmt::format(
                "“{}” may be a fraction or thousands; type it with a point or without the comma.",
                typed)};
        }
        plain[comma] = plain.find('.') == std::string::npos ? '.' : ',';
    }
    const auto value = parsed_number<double>(plain);
    if (!value || !std::isfinite(*value)) return Error{fmt::format("“{}” is not a number.", typed)};
    return *value;
}

}  // namespace cambrian
