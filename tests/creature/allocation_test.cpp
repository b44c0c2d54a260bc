#include "creature/builders.h"
#include "creature/creature.h"
#include "support/allocation_count.h"
#include "support/catch.h"

using namespace cambrian;
using test::allocation_count;

TEST_CASE("a tick of control allocates nothing", "[creature]") {
    const SceneSettings settings;
    FounderSettings founders;
    for (const ChannelEntry& channel : kinds().catalog.channels)
        founders.channels[channel.id] = true;
    RandomStream stream(stream_seed(9, 0, 0, Purpose::kTest));
    for (int i = 0; i < 100; ++i) {
        const Phenotype phenotype = express(random_genome(founders, kinds().catalog, stream));
        Creature creature(phenotype, kinds(), settings);
        FakeScene scene(phenotype.parts.size());
        const std::size_t before = allocation_count();
        for (int tick = 0; tick < 10; ++tick)
            creature.act(scene, FakeSurroundings(), 1.0 / 60.0);
        creature.hold_rest(scene);
        const std::size_t after = allocation_count();
        REQUIRE(after == before);
    }
    CHECK(allocation_count() > 0);
}
