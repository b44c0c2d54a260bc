#include "core/text/parsed_number.h"

#include "support/catch.h"

#include <cstdint>

namespace cambrian {
namespace {

TEST_CASE("text is a number only if all of it is", "[core][parsed_number]") {
    CHECK(parsed_number<int>("-12") == -12);
    CHECK(parsed_number<double>("2.5e3") == 2500.0);
    for (const char* text : {"", " 1", "1 ", "1x", "x", "+1", "1,5"})
        CHECK_FALSE(parsed_number<double>(text));
}

TEST_CASE("numbers that a type cannot hold are refused", "[core][parsed_number]") {
    CHECK(parsed_number<std::uint8_t>("255") == 255);
    CHECK_FALSE(parsed_number<std::uint8_t>("256"));
    CHECK_FALSE(parsed_number<unsigned>("-1"));
    CHECK_FALSE(parsed_number<int>("1.0"));
}

TEST_CASE("lists of numbers have one space between neighbours", "[core][parsed_number]") {
    CHECK(parsed_numbers<int>("", 3) == std::vector<int>());
    CHECK(parsed_numbers<int>("4 5 6", 3) == std::vector<int>{4, 5, 6});
    for (const char* text : {" 4", "4 ", "4  5", "4,5", "4 five", " "})
        CHECK_FALSE(parsed_numbers<int>(text, 3));
}

TEST_CASE("lists of more numbers than allowed are refused", "[core][parsed_number]") {
    CHECK(parsed_numbers<int>("4 5 6", 3));
    CHECK_FALSE(parsed_numbers<int>("4 5 6 7", 3));
}

}  // namespace
}  // namespace cambrian
