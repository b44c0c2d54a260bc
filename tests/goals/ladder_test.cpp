// The ladder of walking, evolution.md 7.2: what falls or hops once must not pay, what crawls must.
#include "evolution/evaluation.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

using namespace cambrian;

namespace {

EvaluationResult walk(const GenomePtr& genome) {
    return evaluate({genome, 0, 0}, ExperimentSettings{}, test::kinds());
}

const KindCatalog& catalog() {
    return test::kinds().creature.catalog;
}

}  // namespace

TEST_CASE("a rigid tower and a creature without live control score nothing", "[goals][ladder]") {
    CHECK(walk(test::rigid_tower(catalog())).outcome == Outcome::kRejected);
    CHECK(walk(test::rigid_tower(catalog())).fitness == 0.0);
    CHECK(walk(test::dreamer(catalog())).outcome == Outcome::kRejected);
}

TEST_CASE("a tower that tips itself over scores below 0.02, whenever it falls", "[goals][ladder]") {
    for (const double delay : {0.1, 6.0, 9.0}) {
        const EvaluationResult result = walk(test::falling_tower(catalog(), delay));
        CAPTURE(delay);
        CHECK(result.outcome == Outcome::kCompleted);
        CHECK(result.body_length > 2.0);
        CHECK(result.fitness < 0.02);
    }
}

TEST_CASE("a body with two sine-driven legs crawls", "[goals][ladder]") {
    const EvaluationResult result = walk(test::crawler(catalog()));
    CHECK(result.outcome == Outcome::kCompleted);
    CHECK(result.fitness > 0.02);
}
