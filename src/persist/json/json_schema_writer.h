#pragma once

// Writes the rules of a format as a JSON Schema. It has the same calls as JsonReader and
// JsonWriter, so one description such as creature_format.h serves all three. Values are prototypes:
// only their types matter.

#include "core/assert.h"
#include "persist/json/json_value.h"
#include "persist/text/setting_value.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cambrian {

struct FieldRule;

// Has the functions of JsonReader, in whose place a description calls it.
class JsonSchemaWriter {
public:
    using Json = nlohmann::ordered_json;

    // The parts that all objects of a schema share.
    struct Library {
        // Returns the meaning of a key of a type, in words.
        std::function<std::string(std::string_view type, std::string_view key)> meaning;
        Json definitions = Json::object();  // schemas of the types, by name
    };

    // Returns the schema of the described object; the schemas of its types are added to the
    // library.
    template <class Describe>
    static Json object_schema(Library& library, Describe describe) {
        Variants variants;
        std::string type;
        std::size_t count = 1;
        for (std::size_t i = 0; i < count; ++i) {
            JsonSchemaWriter writer(library, i);
            describe(writer);
            type = writer.type_;
            count = writer.variant_count_;
            if (writer.allowed_) variants.add(std::move(writer.rules_));
        }
        return define(library, type, variants.schema());
    }

    void type(const char* name) { type_ = name; }
    // Returns true, so that the description includes optional keys.
    bool has(const char* key) {
        optional_key_ = key;
        return true;
    }
    template <class Message>
    void require(bool condition, const char* /*code*/, const char* /*key*/, Message /*message*/) {
        if (!condition) allowed_ = false;
    }
    template <class Message>
    void require_count(const char* key, std::size_t /*found*/, std::size_t count,
                       const char* /*code*/, Message /*message*/) {
        fix_count(key, count);
    }

    void real(const char* key, double value, const FieldRule& rule);
    void pair(const char* key, double first, const FieldRule& first_rule, double second,
              const FieldRule& second_rule);
    void plain_real(const char* key, double value);
    template <class Integer>
    void integer(const char* key, Integer /*value*/, double low, double high) {
        put(key, whole_number(low, high));
    }
    template <class Integer>
    void index(const char* key, Integer /*value*/, std::size_t count, const char* /*of_what*/) {
        put(key, whole_number(0.0, static_cast<double>(count) - 1.0));
    }
    void flag(const char* key, bool value);
    template <class Choice>
    bool choice(const char* key, const Choice& /*value*/, std::span<const std::string> names,
                const char* /*what*/) {
        put(key, one_of(names));
        return true;
    }
    template <class Choice>
    void optional_choice(const char* key, const Choice& value, std::span<const std::string> names,
                         const char* what) {
        has(key);
        choice(key, value, names, what);
    }
    template <class Integer>
    void named_or_numbered(const char* key, Integer /*value*/, const NumberedNames& names,
                           const char* /*what*/) {
        put(key, {{"anyOf",
                   Json::array({one_of(names.names), whole_number(0.0, NumberedNames::kMost)})}});
    }
    // The object is described once for each of the names.
    template <class Choice>
    bool variant(const char* key, Choice& value, std::span<const std::string> names,
                 const char* /*what*/) {
        CAMBRIAN_ASSERT(variant_count_ == 1, "one variant an object");
        variant_count_ = names.size();
        value = static_cast<Choice>(variant_);
        rules_.variant_key = key;
        put(key, one_of(names.subspan(variant_, 1)));
        return true;
    }
    void text(const char* key, std::string_view value, std::size_t max_bytes);
    // A text that can have one value only.
    void constant(const char* key, Json value);
    void texts(const char* key, const std::vector<std::string>& values, std::size_t max_count,
               std::size_t max_bytes);
    void digest(const char* key, std::uint64_t value);
    void optional_digest(const char* key, const std::optional<std::uint64_t>& /*value*/) {
        has(key);
        digest(key, 0);
    }
    void optional_bytes(const char* key, std::span<const std::uint8_t> bytes,
                        std::size_t line_bytes, std::size_t max_bytes);
    void setting(const SettingField& field, ExperimentSettings& settings);

    template <class Describe>
    void object(const char* key, JsonLayout /*layout*/, Describe describe) {
        const bool optional = take_optional(key);
        put(key, object_schema(library_, describe), optional);
    }
    template <class Value, class Describe>
    void optional_object(const char* key, std::optional<Value>& value, JsonLayout /*layout*/,
                         Describe describe) {
        value.emplace();
        put(key, object_schema(library_, [&](JsonSchemaWriter& inner) { describe(inner, *value); }),
            true);
    }
    template <class Items, class Describe>
    void optional_list(const char* key, Items& items, std::size_t high, JsonLayout layout,
                       Describe describe) {
        has(key);
        list(key, items, 0, high, layout, describe);
    }
    template <class Items, class Describe>
    void list(const char* key, Items& /*items*/, std::size_t low, std::size_t high,
              JsonLayout /*layout*/, Describe describe) {
        const bool optional = take_optional(key);
        typename Items::value_type item{};
        put(key,
            list_of(
                object_schema(library_, [&](JsonSchemaWriter& inner) { describe(inner, item); }),
                low, high),
            optional);
    }

private:
    // The rules of one variant of an object.
    struct Rules {
        Json properties = Json::object();
        Json required = Json::array();
        std::string variant_key;  // empty if there is only one variant
    };
    class Variants {
    public:
        // Adds a variant; variants that differ only in their key's value are joined.
        void add(Rules rules);
        Json schema() const;

    private:
        std::vector<Rules> all_;
    };

    void fix_count(const char* key, std::size_t count);
    JsonSchemaWriter(Library& library, std::size_t variant)
        : library_(library), variant_(variant) {}

    static Json define(Library& library, const std::string& type, Json schema);
    static Json whole_number(double low, double high);
    static Json one_of(std::span<const std::string> names);
    static Json list_of(Json item, std::size_t low, std::size_t high);
    bool take_optional(std::string_view key);
    void put(const char* key, const Json& schema) { put(key, schema, take_optional(key)); }
    void put(const char* key, const Json& schema, bool optional);
    void put_described(const char* key, const std::string& meaning, const Json& schema,
                       bool optional);

    Library& library_;
    std::size_t variant_;  // index of the variant being described
    std::size_t variant_count_ = 1;
    bool allowed_ = true;  // whether that variant exists
    std::string type_;
    std::string optional_key_;  // optional key that was asked for last
    Rules rules_;
};

}  // namespace cambrian
