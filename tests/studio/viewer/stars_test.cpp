#include "studio/viewer/stars.h"

#include "support/catch.h"

namespace cambrian {
namespace {

JudgedIndividual creature(std::uint32_t generation) {
    auto individual = std::make_shared<Individual>();
    individual->genome = std::make_shared<const Genome>();
    return {generation, individual, nullptr};
}

TEST_CASE("a star can be given, removed and restored", "[studio][stars]") {
    Stars stars;
    const JudgedIndividual first = creature(3);
    const JudgedIndividual second = creature(4);
    stars.toggle(first);
    stars.toggle(second);
    CHECK(stars.all().size() == 2);
    CHECK_FALSE(stars.can_restore());
    const auto before = stars.revision();
    stars.toggle(first);
    CHECK_FALSE(stars.has(*first.individual));
    CHECK(stars.revision() != before);
    stars.restore();
    CHECK(stars.has(*first.individual));
    CHECK_FALSE(stars.can_restore());
    stars.restore();
    CHECK(stars.all().size() == 2);
}

TEST_CASE("a survivor of the next generation has the star of its genome", "[studio][stars]") {
    Stars stars;
    const JudgedIndividual creature_then = creature(3);
    stars.toggle(creature_then);
    Individual now = *creature_then.individual;
    now.result.fitness = 7.0;
    CHECK(stars.has(now));
    CHECK_FALSE(stars.has(*creature(3).individual));
}

}  // namespace
}  // namespace cambrian
