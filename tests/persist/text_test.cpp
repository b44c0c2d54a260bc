#include "persist/text/digest_text.h"
#include "persist/text/error_list.h"
#include "persist/text/quoted_text.h"
#include "support/catch.h"

using namespace cambrian;

TEST_CASE("digests are written and read with their kind", "[persist][digest_text]") {
    CHECK(digest_text(0x5d0c1eULL) == "fnv1a64:00000000005d0c1e");
    CHECK(parse_digest("fnv1a64:00000000005d0c1e") == 0x5d0c1eULL);
    CHECK(parse_digest("fnv1a64:ffffffffffffffff") == 0xffffffffffffffffULL);
    for (const char* wrong : {"", "fnv1a64:", "5d0c1e", "fnv1a64:xyz", "fnv1a64:-1", "md5:00",
                              "fnv1a64:00000000000000001"})
        CHECK_FALSE(parse_digest(wrong));
}

TEST_CASE("texts are quoted with the escapes of JSON and TOML", "[persist][quoted_text]") {
    CHECK(quoted_text("a\"b\\c") == "\"a\\\"b\\\\c\"");
    CHECK(quoted_text("\n\x7f") == "\"\\u000a\\u007f\"");
    CHECK(quoted_text("žába 蛙 🦎") == "\"žába 蛙 🦎\"");
}

TEST_CASE("bytes that are not UTF-8 are replaced one by one", "[persist][quoted_text]") {
    CHECK(quoted_text("\xff") == "\"?\"");
    CHECK(quoted_text("a\xc5") == "\"a?\"");
    CHECK(quoted_text("\xc0\x80") == "\"??\"");            // overlong
    CHECK(quoted_text("\xed\xa0\x80") == "\"???\"");       // half of a surrogate pair
    CHECK(quoted_text("\xf4\x90\x80\x80") == "\"????\"");  // beyond Unicode
}

TEST_CASE("characters that steer a terminal are escaped", "[persist][quoted_text]") {
    CHECK(quoted_text("\xc2\x9b") == "\"\\u009b\"");
    CHECK(quoted_text("RED\xe2\x80\xae") == "\"RED\\u202e\"");
    CHECK(quoted_text("\xef\xbb\xbf") == "\"\\ufeff\"");
}

TEST_CASE("messages show foreign text short and printable", "[persist][error_list]") {
    CHECK(in_quotes("a\nb") == "\"a?b\"");
    CHECK(shown(std::string(1000, 'x')) == std::string(48, 'x') + "...");
}
