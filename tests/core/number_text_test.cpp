#include "core/text/number_text.h"

#include "core/random.h"
#include "support/catch.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace cambrian;

TEST_CASE("a written number reads back to the same bits", "[core][number_text]") {
    RandomStream stream(51);
    for (int i = 0; i < 100000; ++i) {
        const double number = std::bit_cast<double>(stream.bits());
        if (!std::isfinite(number)) continue;
        const double back = std::strtod(real_text(number).c_str(), nullptr);
        REQUIRE(std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(number));
    }
}

TEST_CASE("a written real number looks like one", "[core][number_text]") {
    CHECK(real_text(1.0) == "1.0");
    CHECK(real_text(-0.0) == "-0.0");
    CHECK(real_text(0.1) == "0.1");
    CHECK(real_text(1e-5) == "1e-05");
    CHECK(real_text(1e300) == "1e+300");
    CHECK(real_text(std::numeric_limits<double>::infinity()) == "inf");
}

TEST_CASE("for people whole numbers have no point", "[core][number_text]") {
    CHECK(short_text(9.81) == "9.81");
    CHECK(short_text(1000.0) == "1000");
    CHECK(short_text(1e-8) == "1e-08");
    CHECK(short_text(1e9) == "1000000000");
    CHECK(short_text(1e300) == "1e+300");
}
