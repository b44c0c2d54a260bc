#include "studio/widgets/typed_number.h"

#include "support/catch.h"

namespace cambrian {
namespace {

TEST_CASE("numbers are read as people type them", "[studio][typed_number]") {
    const auto value = [](const char* text, const char* unit = "") {
        INFO(text);
        const Result<double> typed = typed_number(text, unit);
        REQUIRE(typed);
        return *typed;
    };
    CHECK(value("1.5") == 1.5);
    CHECK(value("1,5") == 1.5);
    CHECK(value("0,125") == 0.125);
    CHECK(value(" +7 ") == 7.0);
    CHECK(value("−2,25") == -2.25);
    CHECK(value("1e-3") == 1e-3);
    CHECK(value("9.81 m/s²", "m/s²") == 9.81);
    CHECK(value("30°", "°") == 30.0);
}

TEST_CASE("what is no number, or may be two, is refused", "[studio][typed_number]") {
    for (const char* text : {"", " ", "0x10", "1 5", "1.5.2", "1,5,2", "1,234.5", "12a", "--1",
                             "inf", "nan", "1e999", "5 m"}) {
        INFO(text);
        CHECK_FALSE(typed_number(text));
    }
    const Result<double> doubtful = typed_number("1,500");
    REQUIRE_FALSE(doubtful);
    CHECK_THAT(doubtful.error().message, Catch::StartsWith("“1,500” may be"));
    CHECK(typed_number("0x10").error().message == "“0x10” is not a number.");
}

}  // namespace
}  // namespace cambrian
