#include "genome/founders/random_genome.h"
#include "simulator/trial.h"
#include "support/allocation_count.h"
#include "support/catch.h"
#include "support/kinds.h"

using namespace cambrian;
using test::allocation_count;

TEST_CASE("a trial allocates nothing from its first tick to its last", "[simulator]") {
    const Kinds& kinds = test::kinds().creature;
    TrialWorld world;
    world.trial.duration = 2.0;
    world.trial.stop_at_rest = true;
    FounderSettings founders;
    for (const ChannelEntry& channel : kinds.catalog.channels)
        founders.channels[channel.id] = true;
    for (const OrganEntry& organ : kinds.catalog.organs)
        founders.organs[organ.id] = true;
    RandomStream stream(stream_seed(9, 0, 0, Purpose::kTest));
    int completed = 0;
    for (int i = 0; i < 40; ++i) {
        const Genome genome = random_genome(founders, kinds.catalog, stream);
        const auto phenotype = std::make_shared<const Phenotype>(
            express(genome, kinds, ExpressionSettings{}, world.scene));
        auto trial = Trial::start(phenotype, kinds, world);
        REQUIRE(trial);
        while ((*trial)->settling() && (*trial)->tick()) {
        }
        const std::size_t before = allocation_count();
        while ((*trial)->tick()) {
        }
        const std::size_t after = allocation_count();
        // Failed trials allocate the text of the reason.
        if ((*trial)->record().outcome != Outcome::kCompleted) continue;
        REQUIRE(after == before);
        ++completed;
    }
    CHECK(completed > 30);
}
