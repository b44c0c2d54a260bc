// What a creature loses without its senses: one that needs them and one that hears them in vain.
#include "evolution/evaluation/sense_losses.h"

#include "evolution/settings/goal_defaults.h"
#include "persist/creature/creature_file.h"
#include "support/catch.h"
#include "support/kinds.h"

using namespace cambrian;
using test::kinds;

namespace {

CreatureDocument sample_of(const char* name) {
    auto document =
        load_creature(std::string(CAMBRIAN_SOURCE_DIR "/assets/creatures/") + name, kinds());
    REQUIRE(document);
    return *std::move(document);
}

SenseLosses losses_of(const char* sample) {
    const CreatureDocument document = sample_of(sample);
    double done = 0.0;
    const SenseLosses losses =
        sense_losses(document.creature.individual->genome, document.settings(), kinds(), {},
                     [&done](double share) {
                         CHECK(share >= done);
                         done = share;
                     });
    CHECK(done > 0.9);
    CHECK(done < 1.0);
    return losses;
}

bool needs(const char* sample) {
    const CreatureDocument document = sample_of(sample);
    return needs_senses(document.creature.individual->genome, document.settings(), kinds());
}

}  // namespace

TEST_CASE("who walks away from a wall on either side needs to sense it", "[evolution][senses]") {
    const SenseLosses losses = losses_of("dodger.creature.json");
    CHECK(losses.intact > 0.6);
    CHECK(losses.without_all < 0.2 * losses.intact);
    CHECK(needs("dodger.creature.json"));
    REQUIRE_FALSE(losses.each.empty());
    double least = losses.intact;
    for (const SenseLoss& loss : losses.each)
        least = std::min(least, loss.score);
    CHECK(least < 0.9 * losses.intact);
}

TEST_CASE("a walker that hears its senses in vain loses nothing", "[evolution][senses]") {
    const SenseLosses losses = losses_of("pacer.creature.json");
    REQUIRE_FALSE(losses.each.empty());
    CHECK(losses.without_all > 0.9 * losses.intact);
    CHECK_FALSE(needs("pacer.creature.json"));
}
