#pragma once

// Writes a document: small objects on one line, keys in the order of the calls. It has the same
// calls as JsonReader, so one description of a format serves both (creature_format.h).

#include "core/assert.h"
#include "persist/json/json_text.h"
#include "persist/text/quoted_text.h"
#include "persist/text/setting_value.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

struct FieldRule;

class JsonWriter {
public:
    // Writes one object into `text`: the constructor begins it, end() ends it.
    explicit JsonWriter(std::string& text, JsonLayout layout = JsonLayout::kLines) : json_(text) {
        json_.open('{', layout);
    }
    void end() { json_.close('}'); }

    void type(const char* /*name*/) const {}
    bool has(const char* /*key*/) const { return true; }
    template <class Message>
    void require(bool condition, const char* /*code*/, const char* /*key*/,
                 Message /*message*/) const {
        CAMBRIAN_ASSERT(condition, "only valid documents are written");
    }

    template <class Message>
    void require_count(const char* key, std::size_t found, std::size_t count, const char* code,
                       Message message) const {
        require(found == count, code, key, message);
    }

    void real(const char* key, double value, const FieldRule& rule);
    void pair(const char* key, double first, const FieldRule& first_rule, double second,
              const FieldRule& second_rule);
    void plain_real(const char* key, double value);
    template <class Integer>
    void integer(const char* key, Integer value, double /*low*/, double /*high*/) {
        json_.item(key, std::to_string(value));
    }
    template <class Integer>
    void index(const char* key, Integer value, std::size_t /*count*/, const char* /*of_what*/) {
        json_.item(key, std::to_string(value));
    }
    void flag(const char* key, bool value) { json_.item(key, value ? "true" : "false"); }
    template <class Choice>
    bool choice(const char* key, Choice value, std::span<const std::string> names,
                const char* /*what*/) {
        json_.item(key, quoted_text(names[static_cast<std::size_t>(value)]));
        return true;
    }
    // Writes a choice unless it is the first of the names.
    template <class Choice>
    void optional_choice(const char* key, Choice value, std::span<const std::string> names,
                         const char* what) {
        if (static_cast<std::size_t>(value) != 0) choice(key, value, names, what);
    }
    template <class Integer>
    void named_or_numbered(const char* key, Integer value, const NumberedNames& names,
                           const char* /*what*/) {
        const auto index = static_cast<std::size_t>(value);
        json_.item(key, index < names.names.size() ? quoted_text(names.names[index])
                                                   : std::to_string(index));
    }
    template <class Choice>
    bool variant(const char* key, Choice value, std::span<const std::string> names,
                 const char* what) {
        return choice(key, value, names, what);
    }
    void text(const char* key, std::string_view value, std::size_t /*max_bytes*/) {
        json_.item(key, quoted_text(value));
    }
    void texts(const char* key, const std::vector<std::string>& values, std::size_t max_count,
               std::size_t max_bytes);
    void digest(const char* key, std::uint64_t value);
    // Writes a digest if there is a value.
    void optional_digest(const char* key, const std::optional<std::uint64_t>& value) {
        if (value) digest(key, *value);
    }
    // Writes the bytes if there are any.
    void optional_bytes(const char* key, std::span<const std::uint8_t> bytes,
                        std::size_t line_bytes, std::size_t max_bytes);
    void setting(const SettingField& field, const ExperimentSettings& settings) {
        const SettingValue value = value_of(field, settings);
        if (field.later && value == value_of(field, ExperimentSettings{})) return;
        json_.item(field.key.c_str(), setting_text(value));
    }

    template <class Describe>
    void object(const char* key, JsonLayout layout, Describe describe) {
        json_.begin_item(key);
        json_.open('{', layout);
        describe(*this);
        json_.close('}');
    }
    // Writes an object if there is a value.
    template <class Value, class Describe>
    void optional_object(const char* key, const std::optional<Value>& value, JsonLayout layout,
                         Describe describe) {
        if (!value) return;
        object(key, layout, [&](JsonWriter& writer) { describe(writer, *value); });
    }
    // Writes a list if it has any items.
    template <class Items, class Describe>
    void optional_list(const char* key, Items& items, std::size_t high, JsonLayout layout,
                       Describe describe) {
        if (!items.empty()) list(key, items, 0, high, layout, describe);
    }
    // Writes one object per item.
    template <class Items, class Describe>
    void list(const char* key, Items& items, std::size_t /*low*/, std::size_t /*high*/,
              JsonLayout layout, Describe describe) {
        json_.begin_item(key);
        json_.open('[', JsonLayout::kLines);
        for (auto& each : items) {
            json_.begin_item("");
            json_.open('{', layout);
            describe(*this, each);
            json_.close('}');
        }
        json_.close(']');
    }

private:
    JsonText json_;
};

}  // namespace cambrian
