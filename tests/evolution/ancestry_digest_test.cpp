#include "evolution/individual/ancestry_digest.h"

#include "support/catch.h"

#include <memory>

using namespace cambrian;

namespace {

std::shared_ptr<Individual> child_of(IndividualPtr mother, std::uint64_t uid) {
    auto child = std::make_shared<Individual>();
    child->uid = uid;
    child->born = static_cast<std::uint32_t>(uid);
    child->method = "asexual";
    child->genome_hash = 7 * uid;
    if (mother) child->parents = {mother->uid, 0};
    child->mother = ParentLink(std::move(mother));
    return child;
}

}  // namespace

TEST_CASE("an ancestry's digest covers all of the line", "[evolution][ancestry_digest]") {
    const auto first = child_of(nullptr, 1);
    const auto second = child_of(first, 2);
    const auto third = child_of(second, 3);
    const std::uint64_t digest = ancestry_digest(*third);
    CHECK(digest == ancestry_digest(*child_of(child_of(child_of(nullptr, 1), 2), 3)));
    CHECK(digest != ancestry_digest(*second));
    CHECK(digest != ancestry_digest(*child_of(nullptr, 3)));
    const auto changed = GENERATE(0, 1, 2, 3);
    if (changed == 0) first->genome_hash = 8;
    if (changed == 1) first->method = "random";
    if (changed == 2) second->parents[1] = 9;
    if (changed == 3) first->born = 5;
    CHECK(digest != ancestry_digest(*third));
}

TEST_CASE("a score is no part of an ancestry", "[evolution][ancestry_digest]") {
    const auto one = child_of(nullptr, 1);
    const std::uint64_t digest = ancestry_digest(*one);
    one->evaluated = true;
    one->result.fitness = 3.0;
    CHECK(digest == ancestry_digest(*one));
}
