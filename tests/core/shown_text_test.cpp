#include "core/text/shown_text.h"

#include "support/catch.h"

using namespace cambrian;

TEST_CASE("foreign text is shown without what steers a terminal", "[core][shown_text]") {
    CHECK(shown("\x1b]0;owned\x07") == "?]0;owned?");
    CHECK(shown("a\nb\tc\x7f") == "a?b?c?");
    CHECK(shown("a\xc2\x9b"
                "31m") == "a?31m");  // U+009B begins a sequence, too
    CHECK(shown("RED\xe2\x80\xae"
                "DER") == "RED?DER");  // U+202E
    CHECK(shown("\xe2\x81\xa6x\xe2\x81\xa9") == "?x?");
    CHECK(shown("\xef\xbb\xbfx") == "?x");
    CHECK(shown("žába 蛙 🦎 עברית") == "žába 蛙 🦎 עברית");
    CHECK(shown_lines("a\n\tb\r\x1b") == "a\n\tb??");
    CHECK(shown_whole(std::string(1000, 'x')) == std::string(1000, 'x'));
}

TEST_CASE("foreign text is shown as UTF-8, cut between characters", "[core][shown_text]") {
    CHECK(shown("\xff"
                "a\xc5") == "?a?");
    CHECK(shown("\xed\xa0\x80") == "???");
    CHECK(shown("žžž", 3) == "ž...");
    CHECK(shown("🦎🦎", 7) == "🦎...");
    CHECK(in_quotes("a\nb") == "\"a?b\"");
}

TEST_CASE("cells of CSV are no formulas and keep their text", "[core][shown_text]") {
    CHECK(csv_cell("asexual") == "asexual");
    CHECK(csv_cell("=HYPERLINK(1)") == "\"'=HYPERLINK(1)\"");
    for (const char* text : {"+1", "-1", "@a", "=a,b", "a \"b\" c", "a;b", "", "'", "\""}) {
        const std::string line = csv_cell(text) + ",next";
        INFO(line);
        std::string_view rest = line;
        CHECK(text_of_csv_cell(take_csv_cell(rest)) == text);
        CHECK(rest == "next");
        CHECK(std::string_view("=+-@").find(line.front()) == std::string_view::npos);
    }
}
