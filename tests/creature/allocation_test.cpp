// Counts every allocation of this test program.

#include "creature/builders.h"
#include "creature/creature.h"
#include "support/catch.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}

using namespace cambrian;

TEST_CASE("a tick of control allocates nothing", "[creature]") {
    const SceneSettings settings;
    RandomStream stream(stream_seed(9, 0, 0, Purpose::kTest));
    for (int i = 0; i < 100; ++i) {
        const Phenotype phenotype = express(random_genome({}, kinds().catalog, stream));
        Creature creature(phenotype, kinds(), settings);
        FakeScene scene(phenotype.parts.size());
        const std::size_t before = allocations;
        for (int tick = 0; tick < 10; ++tick)
            creature.act(scene, 1.0 / 60.0);
        creature.hold_rest(scene);
        const std::size_t after = allocations;
        REQUIRE(after == before);
    }
    CHECK(allocations > 0);
}
