#include "persist/records/mutation_text.h"

#include "persist/json/json_text.h"
#include "persist/text/quoted_text.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::size_t kWords = 4;
constexpr JsonLimits kMutationLimits{.bytes = kLongestMutations};

bool is_record(const JsonValue& value) {
    return value.kind == JsonValue::Kind::kList && value.values.size() == kWords &&
           std::all_of(value.values.begin(), value.values.end(),
                       [](const JsonValue& word) { return word.kind == JsonValue::Kind::kText; });
}

}  // namespace

std::optional<std::string> mutations_text(std::span<const MutationRecord> mutations) {
    if (mutations.empty()) return std::nullopt;
    std::vector<std::string> records;
    for (const MutationRecord& each : mutations) {
        records.push_back(json_list({quoted_text(each.operator_id), quoted_text(each.place),
                                     quoted_text(each.from), quoted_text(each.to)},
                                    JsonLayout::kDense));
    }
    return json_list(records, JsonLayout::kDense);
}

Result<std::vector<MutationRecord>> parse_mutations(std::string_view text) {
    ErrorList errors;
    const auto list = parse_json(text, kMutationLimits, errors);
    if (!list) return errors.as_error("mutations");
    if (list->kind != JsonValue::Kind::kList ||
        !std::all_of(list->values.begin(), list->values.end(), is_record))
        return Error{"mutations: expected a list of [operator, place, from, to]"};
    std::vector<MutationRecord> mutations;
    for (const JsonValue& each : list->values)
        mutations.push_back(
            {each.values[0].text, each.values[1].text, each.values[2].text, each.values[3].text});
    return mutations;
}

}  // namespace cambrian
