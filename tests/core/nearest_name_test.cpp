#include "core/text/nearest_name.h"

#include "support/catch.h"

#include <vector>

using namespace cambrian;

namespace {

const std::vector<std::string> kKeys = {"gravity", "friction", "elasticity", "seed", "size"};

}  // namespace

TEST_CASE("a slip of the finger finds the name that was meant", "[core][nearest_name]") {
    CHECK(nearest_name("gravty", kKeys) == "gravity");
    CHECK(nearest_name("frictoin", kKeys) == "friction");
    CHECK(nearest_name("elasticities", kKeys) == "elasticity");
    CHECK(nearest_name("sed", kKeys) == "seed");
    CHECK(nearest_name("gravity", kKeys) == "gravity");
}

TEST_CASE("a name unlike all others finds none", "[core][nearest_name]") {
    CHECK(nearest_name("temperature", kKeys).empty());
    CHECK(nearest_name("", kKeys).empty());
    CHECK(nearest_name("gravity", {}).empty());
}

TEST_CASE("of equally near names the first is offered", "[core][nearest_name]") {
    const std::vector<std::string> known = {"cat", "bat"};
    CHECK(nearest_name("rat", known) == "cat");
}

TEST_CASE("a very long name is near to nothing", "[core][nearest_name]") {
    CHECK(nearest_name(std::string(5000, 'x'), kKeys).empty());
}
