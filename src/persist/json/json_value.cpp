#include "persist/json/json_value.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

// Some editors write it at the start; it is ignored.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr int kNumberOverflow = 406;  // the parser's number for that error

std::string megabytes(std::size_t bytes) {
    const std::size_t tenths = (bytes + 50'000) / 100'000;
    return fmt::format("{}.{} MB", tenths / 10, tenths % 10);
}

std::string line_and_column(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, position == 0 ? 0 : position - 1);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const std::size_t last = before.rfind('\n');
    const std::size_t column = before.size() - (last == std::string_view::npos ? 0 : last + 1);
    return fmt::format("line {}, column {}", lines + 1, column + 1);
}

// Returns the parser's explanation without its preamble and the text it had read.
std::string reason_of(std::string_view what) {
    const std::size_t dash = what.find(" - ");
    std::string_view reason = dash == std::string_view::npos ? what : what.substr(dash + 3);
    const std::size_t read = reason.find("; last read");
    const std::size_t expected = reason.rfind("; expected ");
    std::string result(reason.substr(0, std::min(read, expected)));
    if (expected != std::string_view::npos) result += reason.substr(expected);
    return result;
}

// Builds the tree from the parser's events. An event that exceeds a limit ends the parsing.
class TreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
public:
    TreeBuilder(std::string_view text, const JsonLimits& limits, ErrorList& errors)
        : text_(text), limits_(limits), errors_(errors) {}

    JsonValue take_root() { return std::move(root_); }

    bool null() override { return add(Kind::kNull) != nullptr; }
    bool boolean(bool value) override {
        JsonValue* place = add(Kind::kFlag);
        if (place != nullptr) place->flag = value;
        return place != nullptr;
    }
    bool number_integer(number_integer_t value) override {
        return add_number(Kind::kInteger, static_cast<double>(value));
    }
    bool number_unsigned(number_unsigned_t value) override {
        return add_number(Kind::kInteger, static_cast<double>(value));
    }
    bool number_float(number_float_t value, const std::string& /*token*/) override {
        return add_number(Kind::kReal, value);
    }
    bool string(std::string& value) override {
        JsonValue* place = add(Kind::kText);
        if (place != nullptr) place->text = std::move(value);
        return place != nullptr;
    }
    bool binary(binary_t& /*value*/) override { return false; }
    bool start_object(std::size_t /*size*/) override { return open(Kind::kObject); }
    bool start_array(std::size_t /*size*/) override { return open(Kind::kList); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(std::string& name) override {
        std::vector<std::string>& keys = open_.back()->keys;
        if (keys.size() >= limits_.keys) {
            errors_.error("E10", pointer(), fmt::format("more than {} keys", keys.size()));
            return false;
        }
        if (std::find(keys.begin(), keys.end(), name) != keys.end()) {
            errors_.error("E13", pointer(), fmt::format("key {} appears twice", in_quotes(name)));
        }
        keys.push_back(std::move(name));
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::detail::exception& fault) override {
        if (fault.id == kNumberOverflow) {
            errors_.error("E07", pointer(), shown(token) + " is not a finite number");
        } else {
            errors_.error("E01", line_and_column(text_, position), reason_of(fault.what()));
        }
        return false;
    }

private:
    using Kind = JsonValue::Kind;

    // Adds the next value; returns null and reports an error if there are too many.
    JsonValue* add(Kind kind) {
        if (++count_ > limits_.values) {
            errors_.error("E02", pointer(),
                          fmt::format("file too large: more than {} values", limits_.values));
            return nullptr;
        }
        JsonValue* place = open_.empty() ? &root_ : &open_.back()->values.emplace_back();
        place->kind = kind;
        return place;
    }
    bool add_number(Kind kind, double number) {
        JsonValue* place = add(kind);
        if (place != nullptr) place->number = number;
        return place != nullptr;
    }
    bool open(Kind kind) {
        if (open_.size() >= limits_.depth) {
            errors_.error("E02", "", fmt::format("nested deeper than {} levels", limits_.depth));
            return false;
        }
        JsonValue* place = add(kind);
        // An open value's siblings are complete, so its address holds until it is closed.
        if (place != nullptr) open_.push_back(place);
        return place != nullptr;
    }
    bool close() {
        open_.pop_back();
        return true;
    }
    // Returns the JSON pointer of the present value.
    std::string pointer() const {
        std::string place;
        for (std::size_t i = 0; i < open_.size(); ++i) {
            const JsonValue& value = *open_[i];
            const bool innermost = i + 1 == open_.size();
            if (value.kind == Kind::kList) {
                const std::size_t begun = value.values.size();
                place += fmt::format("/{}", innermost ? begun : begun - 1);
            } else if (value.keys.size() > value.values.size() || !innermost) {
                place += "/" + shown(value.keys.back());
            }
        }
        return place;
    }

    std::string_view text_;
    const JsonLimits& limits_;
    ErrorList& errors_;
    JsonValue root_;
    std::vector<JsonValue*> open_;
    std::size_t count_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (keys[i] == key) return &values[i];
    }
    return nullptr;
}

const char* JsonValue::kind_in_words() const {
    switch (kind) {
        case Kind::kNull:
            return "null";
        case Kind::kFlag:
            return "true or false";
        case Kind::kInteger:
        case Kind::kReal:
            return "a number";
        case Kind::kText:
            return "a text";
        case Kind::kList:
            return "a list";
        case Kind::kObject:
            return "an object";
    }
    return "nothing";
}

std::optional<JsonValue> parse_json(std::string_view text, const JsonLimits& limits,
                                    ErrorList& errors) {
    if (text.size() > limits.bytes) {
        errors.error("E02", "",
                     fmt::format("file too large: {}, limit {}", megabytes(text.size()),
                                 megabytes(limits.bytes)));
        return std::nullopt;
    }
    if (text.empty()) {
        errors.error("E01", "", "the file is empty");
        return std::nullopt;
    }
    const std::size_t mark = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    const std::size_t start = std::min(text.find_first_not_of(" \t\r\n", mark), text.size());
    if (start == text.size() || (text[start] != '{' && text[start] != '[')) {
        errors.error("E01", line_and_column(text, start + 1),
                     "this is not a JSON object, as creature files are");
        return std::nullopt;
    }
    // The parser treats a zero byte as the end of the text.
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) {
        errors.error("E01", line_and_column(text, nul + 1), "a byte of value 0, as no text has");
        return std::nullopt;
    }
    TreeBuilder builder(text, limits, errors);
    if (!nlohmann::json::sax_parse(text, &builder)) return std::nullopt;
    return builder.take_root();
}

}  // namespace cambrian
