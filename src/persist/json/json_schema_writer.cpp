#include "persist/json/json_schema_writer.h"

#include "genome/gene_fields.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <cmath>
#include <type_traits>

namespace cambrian {
namespace {

using Json = JsonSchemaWriter::Json;

// Returns an integer if the number is one, as people write ranges.
Json bound(double number) {
    if (number == std::floor(number) && std::fabs(number) < 9e15)
        return static_cast<std::int64_t>(number);
    return number;
}

Json number_between(double low, double high) {
    return {{"type", "number"}, {"minimum", bound(low)}, {"maximum", bound(high)}};
}

Json whole_number_between(double low, double high) {
    Json schema = number_between(low, high);
    schema["type"] = "integer";
    return schema;
}

Json number_schema(const FieldRule& rule) {
    if (rule.whole) return whole_number_between(rule.low, rule.high);
    if (!rule.wraps) return number_between(rule.low, rule.high);
    return {
        {"type", "number"}, {"minimum", bound(rule.low)}, {"exclusiveMaximum", bound(rule.high)}};
}

std::string meaning_with_unit(const std::string& meaning, std::string_view unit) {
    return unit.empty() ? meaning : fmt::format("{} Unit: {}.", meaning, unit);
}

Json text_up_to(std::size_t max_bytes) {
    return {{"type", "string"}, {"maxLength", max_bytes}};
}

}  // namespace

void JsonSchemaWriter::Variants::add(Rules rules) {
    const std::string key = rules.variant_key;
    const auto without = [&](Rules other) {
        other.properties[key].erase("enum");
        return other;
    };
    for (Rules& same : all_) {
        const Rules left = without(same);
        const Rules right = without(rules);
        if (left.properties != right.properties || left.required != right.required) continue;
        same.properties[key]["enum"].push_back(rules.properties[key]["enum"][0]);
        return;
    }
    all_.push_back(std::move(rules));
}

Json JsonSchemaWriter::Variants::schema() const {
    const auto rules_of = [](const Rules& rules) {
        return Json{{"properties", rules.properties}, {"required", rules.required}};
    };
    Json schema = {{"type", "object"}};
    if (all_.size() == 1) {
        schema.update(rules_of(all_.front()));
        return schema;
    }
    for (const Rules& rules : all_)
        schema["oneOf"].push_back(rules_of(rules));
    return schema;
}

Json JsonSchemaWriter::define(Library& library, const std::string& type, Json schema) {
    if (type.empty()) return schema;
    library.definitions[type] = std::move(schema);
    return {{"$ref", "#/$defs/" + type}};
}

Json JsonSchemaWriter::whole_number(double low, double high) {
    return whole_number_between(low, high);
}

Json JsonSchemaWriter::one_of(std::span<const std::string> names) {
    return {{"enum", std::vector<std::string>(names.begin(), names.end())}};
}

Json JsonSchemaWriter::list_of(Json item, std::size_t low, std::size_t high) {
    return {{"type", "array"}, {"items", std::move(item)}, {"minItems", low}, {"maxItems", high}};
}

bool JsonSchemaWriter::take_optional(std::string_view key) {
    return std::exchange(optional_key_, "") == key;
}

void JsonSchemaWriter::put(const char* key, const Json& schema, bool optional) {
    put_described(key, library_.meaning(type_, key), schema, optional);
}

void JsonSchemaWriter::put_described(const char* key, const std::string& meaning,
                                     const Json& schema, bool optional) {
    Json property = {{"description", meaning}};
    property.update(schema);
    rules_.properties[key] = std::move(property);
    if (!optional) rules_.required.push_back(key);
}

void JsonSchemaWriter::fix_count(const char* key, std::size_t count) {
    rules_.properties[key]["minItems"] = count;
    rules_.properties[key]["maxItems"] = count;
}

void JsonSchemaWriter::real(const char* key, double /*value*/, const FieldRule& rule) {
    const std::string meaning = *rule.help != '\0' ? rule.help : library_.meaning(type_, key);
    put_described(key, meaning_with_unit(meaning, rule.unit), number_schema(rule),
                  take_optional(key));
}

void JsonSchemaWriter::plain_real(const char* key, double /*value*/) {
    put(key, {{"type", "number"}});
}

void JsonSchemaWriter::pair(const char* key, double /*first*/, const FieldRule& first_rule,
                            double /*second*/, const FieldRule& second_rule) {
    const Json schema = {
        {"type", "array"},
        {"prefixItems", Json::array({number_schema(first_rule), number_schema(second_rule)})},
        {"minItems", 2},
        {"maxItems", 2}};
    put_described(key, meaning_with_unit(first_rule.help, first_rule.unit), schema,
                  take_optional(key));
}

void JsonSchemaWriter::flag(const char* key, bool /*value*/) {
    put(key, {{"type", "boolean"}});
}

void JsonSchemaWriter::text(const char* key, std::string_view /*value*/, std::size_t max_bytes) {
    put(key, text_up_to(max_bytes));
}

void JsonSchemaWriter::constant(const char* key, Json value) {
    put(key, {{"const", std::move(value)}});
}

void JsonSchemaWriter::texts(const char* key, const std::vector<std::string>& /*values*/,
                             std::size_t max_count, std::size_t max_bytes) {
    put(key, list_of(text_up_to(max_bytes), 0, max_count));
}

void JsonSchemaWriter::digest(const char* key, std::uint64_t /*value*/) {
    put(key, {{"type", "string"}, {"pattern", "^fnv1a64:[0-9a-fA-F]{1,16}$"}});
}

void JsonSchemaWriter::optional_bytes(const char* key, std::span<const std::uint8_t> /*bytes*/,
                                      std::size_t line_bytes, std::size_t max_bytes) {
    const std::string pairs = fmt::format("^([0-9a-f]{{2}}){{1,{}}}$", line_bytes);
    put(key,
        list_of(Json({{"type", "string"}, {"pattern", pairs}}), 1, lines_of(max_bytes, line_bytes)),
        true);
}

void JsonSchemaWriter::setting(const SettingField& field, ExperimentSettings& settings) {
    Json schema = std::visit(
        [&](const auto* at) -> Json {
            using T = std::remove_cvref_t<decltype(*at)>;
            if constexpr (std::is_same_v<T, bool>) return {{"type", "boolean"}, {"default", *at}};
            if constexpr (std::is_same_v<T, std::string>) {
                Json names = one_of(field.choices);
                names["default"] = *at;
                return names;
            }
            if constexpr (std::is_arithmetic_v<T>) {
                Json number = std::is_integral_v<T> ? whole_number(field.low, field.high)
                                                    : number_between(field.low, field.high);
                number["default"] = bound(static_cast<double>(*at));
                return number;
            }
        },
        field.at(settings));
    put_described(field.key.c_str(), meaning_with_unit(field.help, field.unit), schema, true);
}

}  // namespace cambrian
