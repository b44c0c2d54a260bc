#pragma once

// Text of files, other machines and other libraries as it may be shown: in a terminal, a title, a
// table or the window.

#include <cstddef>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::size_t kLongestQuote = 48;    // bytes
inline constexpr std::size_t kLongestReason = 400;  // bytes of another library's message

// Returns one line of valid UTF-8. A question mark replaces each control character (also U+0080
// to U+009F), each character that reorders or hides its neighbours (U+202E and the like) and each
// byte that is no UTF-8. A longer text is cut between two characters and gets "...".
std::string shown(std::string_view text, std::size_t longest = kLongestQuote);
std::string in_quotes(std::string_view text, std::size_t longest = kLongestQuote);
// Returns all of a text in the same way, and keeps line breaks and tabs.
std::string shown_lines(std::string_view text);
// Returns all of a text on one line.
std::string shown_whole(std::string_view text);

// Returns a text as a cell of CSV: on one line, quoted if it has a comma, a quotation mark or a
// semicolon. One that begins like a formula (= + - @) gets an apostrophe before it, since
// spreadsheets would compute it.
std::string csv_cell(std::string_view text);
// Returns the first cell of a line of CSV as it is written there, and removes it and the comma.
std::string_view take_csv_cell(std::string_view& line);
// Returns the text of such a cell.
std::string text_of_csv_cell(std::string_view cell);

// Returns the length of the character of UTF-8 at the start of a text that is not empty, or 0 if
// there is none.
std::size_t utf8_length(std::string_view text);
// Returns whether a character of UTF-8 can be shown; see shown().
bool is_showable(std::string_view character);

}  // namespace cambrian
