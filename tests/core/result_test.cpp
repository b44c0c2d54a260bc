#include "core/result.h"

#include "support/catch.h"

#include <memory>
#include <string>

using namespace cambrian;

TEST_CASE("a result holds its value or its error", "[core][result]") {
    const Result<int> good = 7;
    const Result<int> bad = Error{"no such file"};
    REQUIRE(good);
    CHECK(*good == 7);
    CHECK_FALSE(bad);
    CHECK(bad.error().message == "no such file");
}

TEST_CASE("a result of texts tells a value from an error", "[core][result]") {
    const Result<std::string> empty = std::string();
    REQUIRE(empty.has_value());
    CHECK(empty->empty());
}

TEST_CASE("a result gives up what can only be moved", "[core][result]") {
    Result<std::unique_ptr<int>> made = std::make_unique<int>(3);
    const std::unique_ptr<int> taken = *std::move(made);
    CHECK(*taken == 3);
}

TEST_CASE("a status is success until given an error", "[core][result]") {
    CHECK(Status{}.has_value());
    const Status failed = Error{"disk full"};
    CHECK_FALSE(failed.has_value());
    CHECK(failed.error().message == "disk full");
}
