#pragma once

// Reads one JSON object field by field into variables with given ranges. Errors go to an ErrorList,
// and the variable then keeps its value. It has the same calls as JsonWriter.

#include "persist/json/json_value.h"
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

// A place in a document. Only a message makes a text of it.
struct JsonPlace {
    const JsonPlace* parent = nullptr;                // none for the document
    std::string_view key = {};                        // of a member
    std::optional<std::size_t> index = std::nullopt;  // of an entry of a list, which has no key

    std::string pointer() const;  // JSON pointer, RFC 6901
};

// It has one function for each type of value that a file of ours may hold, and so has the writer of
// schemas, which is called in its place.
class JsonReader {
public:
    // The object, the places around it and `errors` must outlive the reader.
    JsonReader(const JsonValue& object, const JsonPlace& place, ErrorList& errors)
        : object_(object), place_(place), errors_(errors) {}
    JsonReader(const JsonReader&) = delete;
    JsonReader& operator=(const JsonReader&) = delete;

    // Warns of keys that no call has read (W01).
    void end();

    // The name of the described type; only a schema uses it.
    void type(const char* /*name*/) const {}
    bool has(const char* key) const { return object_.find(key) != nullptr; }
    // `message` returns the text of the error.
    template <class Message>
    void require(bool condition, const char* code, const char* key, Message message) {
        if (!condition) errors_.error(code, pointer(key), message());
    }

    // Checks that the list has as many values as another field demands.
    template <class Message>
    void require_count(const char* key, std::size_t found, std::size_t count, const char* code,
                       Message message) {
        require(found == count, code, key, message);
    }

    void real(const char* key, double& value, const FieldRule& rule);
    // Reads a list of two numbers.
    void pair(const char* key, double& first, const FieldRule& first_rule, double& second,
              const FieldRule& second_rule);
    void plain_real(const char* key, double& value);
    // Reads an integer from low to high.
    template <class Integer>
    void integer(const char* key, Integer& value, double low, double high) {
        if (const auto number = whole_number(key, low, high)) value = static_cast<Integer>(*number);
    }
    // Reads an integer below `count`; `of_what` names what is counted.
    template <class Integer>
    void index(const char* key, Integer& value, std::size_t count, const char* of_what) {
        if (const auto number = index_number(key, count, of_what))
            value = static_cast<Integer>(*number);
    }
    void flag(const char* key, bool& value);
    // Reads the index of one of the names of `what`. Returns false if the text is none of them.
    template <class Choice>
    bool choice(const char* key, Choice& value, std::span<const std::string> names,
                const char* what) {
        const auto found = choice_index(key, names, what);
        if (found) value = static_cast<Choice>(*found);
        return found.has_value();
    }
    // Reads a choice; without the key, it is the first of the names.
    template <class Choice>
    void optional_choice(const char* key, Choice& value, std::span<const std::string> names,
                         const char* what) {
        if (has(key)) choice(key, value, names, what);
    }
    // Reads the index of one of the names of `what`, or a number that older files have for it. An
    // unknown number gives an index outside the range of names.
    template <class Integer>
    void named_or_numbered(const char* key, Integer& value, const NumberedNames& names,
                           const char* what) {
        if (const auto found = numbered_index(key, names, what))
            value = static_cast<Integer>(*found);
    }
    // Reads a choice that determines which other fields exist.
    template <class Choice>
    bool variant(const char* key, Choice& value, std::span<const std::string> names,
                 const char* what) {
        return choice(key, value, names, what);
    }
    void text(const char* key, std::string& value, std::size_t max_bytes);
    void texts(const char* key, std::vector<std::string>& values, std::size_t max_count,
               std::size_t max_bytes);
    void digest(const char* key, std::uint64_t& value);
    // Reads a digest if the key exists.
    void optional_digest(const char* key, std::optional<std::uint64_t>& value) {
        if (has(key)) digest(key, value.emplace());
    }
    // Reads a list of texts, each with up to line_bytes bytes as pairs of hexadecimal digits.
    // Without the key, the result is empty.
    void optional_bytes(const char* key, std::vector<std::uint8_t>& bytes, std::size_t line_bytes,
                        std::size_t max_bytes);
    // Reads a setting; without the key, it keeps its value.
    void setting(const SettingField& field, ExperimentSettings& settings);

    template <class Describe>
    void object(const char* key, JsonLayout /*layout*/, Describe describe) {
        const JsonValue* value = member(key, JsonValue::Kind::kObject, "an object");
        if (value != nullptr) read_object(*value, place(key), describe);
    }
    // Reads an object if the key exists.
    template <class Value, class Describe>
    void optional_object(const char* key, std::optional<Value>& value, JsonLayout layout,
                         Describe describe) {
        if (!has(key)) return;
        value.emplace();
        object(key, layout, [&](JsonReader& reader) { describe(reader, *value); });
    }
    // Reads a list if the key exists.
    template <class Items, class Describe>
    void optional_list(const char* key, Items& items, std::size_t high, JsonLayout layout,
                       Describe describe) {
        if (has(key)) list(key, items, 0, high, layout, describe);
    }
    // Reads a list of `low` to `high` objects.
    template <class Items, class Describe>
    void list(const char* key, Items& items, std::size_t low, std::size_t high,
              JsonLayout /*layout*/, Describe describe) {
        const JsonValue* value = sized_list(key, low, high);
        if (value == nullptr) return;
        items.resize(value->values.size());
        const JsonPlace list = place(key);
        for (std::size_t i = 0; i < items.size(); ++i) {
            read_object(value->values[i], entry(list, i),
                        [&](JsonReader& reader) { describe(reader, items[i]); });
        }
    }

private:
    using Kind = JsonValue::Kind;

    JsonPlace place(std::string_view key) const { return {.parent = &place_, .key = key}; }
    static JsonPlace entry(const JsonPlace& list, std::size_t index) {
        return {.parent = &list, .index = index};
    }
    std::string pointer(std::string_view key) const { return place(key).pointer(); }
    // Returns the value of a key if it exists and is of that kind; otherwise null, after an error.
    const JsonValue* member(const char* key, Kind kind, const char* expected);
    const JsonValue* number_member(const char* key, const char* expected);
    const JsonValue* sized_list(const char* key, std::size_t low, std::size_t high);
    void wrong_type(const JsonPlace& where, const char* expected, const JsonValue& found);
    bool check_real(const JsonPlace& where, const JsonValue& value, const FieldRule& rule);
    bool check_size(const JsonPlace& where, const std::string& text, std::size_t max_bytes);
    std::optional<double> whole_number(const char* key, double low, double high);
    std::optional<double> index_number(const char* key, std::size_t count, const char* of_what);
    std::optional<std::size_t> choice_index(const char* key, std::span<const std::string> names,
                                            const char* what);
    std::optional<std::size_t> numbered_index(const char* key, const NumberedNames& names,
                                              const char* what);
    template <class Describe>
    void read_object(const JsonValue& value, const JsonPlace& where, Describe describe) {
        if (value.kind != Kind::kObject) return wrong_type(where, "an object", value);
        JsonReader reader(value, where, errors_);
        describe(reader);
        reader.end();
    }

    const JsonValue& object_;
    JsonPlace place_;
    ErrorList& errors_;
    std::vector<std::string> known_;  // keys that were read
};

}  // namespace cambrian
