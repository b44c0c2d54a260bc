#include "core/text/pretty_text.h"

#include "core/text/code_points.h"
#include "core/text/shown_score.h"
#include "support/catch.h"

#include <limits>

namespace cambrian {
namespace {

TEST_CASE("numbers keep about three digits and no trailing zeros", "[core][pretty_text]") {
    CHECK(pretty_number(9.81) == "9.81");
    CHECK(pretty_number(0.05) == "0.05");
    CHECK(pretty_number(15.0) == "15");
    CHECK(pretty_number(0.0) == "0");
    CHECK(pretty_number(123.456) == "123.5");
}

TEST_CASE("large whole numbers are grouped and negative ones have a true minus",
          "[core][pretty_text]") {
    CHECK(pretty_number(1250.0) == "1 250");
    CHECK(pretty_number(1234567.0) == "1 234 567");
    CHECK(pretty_number(-2.5) == "−2.5");
}

TEST_CASE("very large and very small numbers are written with a power of ten",
          "[core][pretty_text]") {
    CHECK(pretty_number(-9.63e-4) == "−9.63 × 10⁻⁴");
    CHECK(pretty_number(6.02e23) == "6.02 × 10²³");
}

TEST_CASE("what is not a number is a dash", "[core][pretty_text]") {
    CHECK(pretty_number(std::numeric_limits<double>::quiet_NaN()) == "–");
    CHECK(pretty_number(std::numeric_limits<double>::infinity()) == "–");
}

TEST_CASE("units are written with raised digits and degrees follow without a space",
          "[core][pretty_text]") {
    CHECK(with_unit(9.81, "m/s^2") == "9.81 m/s²");
    CHECK(with_unit(-90.0, "deg") == "−90°");
    CHECK(with_unit(3.0, "") == "3");
}

TEST_CASE("times count up in minutes and hours", "[core][pretty_text]") {
    CHECK(pretty_time(3.2) == "0:04");
    CHECK(pretty_time(750.0) == "12:30");
    CHECK(pretty_time(7500.0) == "2 h 05");
}

TEST_CASE("scores have three decimals and never powers of ten", "[core][pretty_text]") {
    CHECK(shown_score(0.5, "BL/s") == "0.500 BL/s");
    CHECK(shown_score(1.25, "") == "1.250");
    CHECK(shown_score(9.63e-4, "m") == "0.001 m");
    CHECK(shown_score(-1e-9, "m") == "0.000 m");
    CHECK(shown_score(-0.0456, "m") == "−0.046 m");
    CHECK(shown_score(12345678.25, "m") == "12 345 678.250 m");
    CHECK(shown_score(std::numeric_limits<double>::quiet_NaN(), "m") == "–");
}

TEST_CASE("a name of several lines is shown on one", "[core][pretty_text]") {
    CHECK(on_one_line("a\nb\tc\x7f") == "a b c ");
    CHECK(on_one_line("Größe") == "Größe");
}

}  // namespace
}  // namespace cambrian
