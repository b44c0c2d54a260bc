#include "persist/settings/toml_nesting.h"

#include <algorithm>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr std::string_view kMarkOfUtf8 = "\xef\xbb\xbf";
constexpr std::size_t kTriple = 3;      // quotes around a text of several lines
constexpr std::size_t kMostQuotes = 5;  // at its end: two of them can belong to it

// Goes through a text letter by letter and follows its tables, lists and names.
class NestingScan {
public:
    explicit NestingScan(std::string_view text)
        : text_(text), place_(text.starts_with(kMarkOfUtf8) ? kMarkOfUtf8.size() : 0) {}

    std::size_t too_deep_line() {
        while (place_ < text_.size()) {
            pass_letter();
            if (depth() > kDeepestToml) return line_;
        }
        return 0;
    }

private:
    void pass_letter() {
        const char letter = text_[place_];
        if (letter == '"' || letter == '\'') {
            begun_ = true;
            pass_text(letter);
            return;
        }
        ++place_;
        switch (letter) {
            case '#':
                place_ = std::min(text_.find('\n', place_), text_.size());
                break;
            case '\n':
                end_line();
                break;
            case '.':
                ++names_;
                break;
            case ',':
                names_ = 0;
                break;
            case '[':
            case '{':
                open_bracket(letter);
                break;
            case ']':
            case '}':
                close_bracket();
                break;
            default:
                begun_ = begun_ || (letter != ' ' && letter != '\t');
        }
    }

    void end_line() {
        ++line_;
        if (!open_.empty()) return;
        in_header_ = false;
        begun_ = false;
        names_ = 0;
    }

    void open_bracket(char letter) {
        const bool begins_header = letter == '[' && !begun_ && open_.empty();
        begun_ = true;
        if (begins_header) {
            in_header_ = true;
            header_ = 0;
        } else if (!in_header_) {
            open_.push_back(depth());
            names_ = 0;
        }
    }

    void close_bracket() {
        if (in_header_) {
            header_ = std::max(header_, names_ + 1);
        } else if (!open_.empty()) {
            open_.pop_back();
        }
        names_ = 0;
    }

    // Passes a quoted text, which begins here.
    void pass_text(char quote) {
        const std::size_t quotes = run_of(quote, kTriple);
        place_ += quotes == 2 ? 2 : quotes == kTriple ? kTriple : 1;
        if (quotes == 2) return;  // it is empty
        const bool several_lines = quotes == kTriple;
        while (place_ < text_.size()) {
            const char letter = text_[place_];
            if (letter == '\n') {
                if (!several_lines) return;  // it has no end
                ++line_;
            }
            if (letter == '\\' && quote == '"') {
                place_ += 1;  // the next letter is no quote
                if (place_ < text_.size() && text_[place_] == '\n') continue;
            } else if (letter == quote) {
                const std::size_t ending = several_lines ? run_of(quote, kMostQuotes) : 1;
                place_ += ending;
                if (!several_lines || ending >= kTriple) return;
                continue;
            }
            ++place_;
        }
    }

    std::size_t run_of(char quote, std::size_t most) const {
        std::size_t count = 0;
        while (count < most && place_ + count < text_.size() && text_[place_ + count] == quote)
            ++count;
        return count;
    }

    // The depth of a value with the name that was read last.
    std::size_t depth() const {
        const std::size_t around = !open_.empty() ? open_.back() : in_header_ ? 0 : header_;
        return around + names_ + 1;
    }

    std::string_view text_;
    std::size_t place_;
    std::size_t line_ = 1;
    std::size_t names_ = 0;   // dots since the last name or value began
    std::size_t header_ = 0;  // levels of the last [header]
    bool in_header_ = false;
    bool begun_ = false;             // whether the line has more than spaces
    std::vector<std::size_t> open_;  // depths of what open brackets hold
};

}  // namespace

std::size_t line_nested_too_deeply(std::string_view text) {
    return NestingScan(text).too_deep_line();
}

}  // namespace cambrian
