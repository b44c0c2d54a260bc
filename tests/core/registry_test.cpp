#include "core/registry.h"

#include "support/catch.h"

#include <string>

using namespace cambrian;

namespace {

struct Fruit {
    std::string id;
    int weight = 0;
};

}  // namespace

TEST_CASE("a registry keeps its kinds in the order they came", "[core][registry]") {
    Registry<Fruit> fruits;
    fruits.add({"pear", 2});
    fruits.add({"apple", 1});
    REQUIRE(fruits.size() == 2);
    CHECK(fruits[0].id == "pear");
    CHECK(fruits.all()[1].id == "apple");
    CHECK(fruits.index_of("apple") == 1U);
}

TEST_CASE("a kind is found by its id and by nothing else", "[core][registry]") {
    Registry<Fruit> fruits;
    fruits.add({"pear", 2});
    REQUIRE(fruits.find("pear") != nullptr);
    CHECK(fruits.find("pear")->weight == 2);
    CHECK(fruits.find("Pear") == nullptr);
    CHECK(fruits.find("") == nullptr);
    CHECK_FALSE(fruits.index_of("pea"));
}
