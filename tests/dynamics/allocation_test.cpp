// Replaces the program's allocator by one that counts while it is told to.

#include "dynamics/bodies.h"
#include "support/catch.h"

#include <cstdlib>
#include <new>

namespace {

thread_local bool counting = false;
thread_local int allocations = 0;

void* counted(std::size_t size) {
    if (counting) ++allocations;
    void* memory = std::malloc(size == 0 ? 1 : size);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

using namespace cambrian;

TEST_CASE("advancing allocates nothing", "[dynamics][allocation]") {
    for (const char* integrator : {"bogacki-shampine", "dormand-prince", "cash-karp"}) {
        RandomStream random(stream_seed({61}));
        const BodyPlan plan = random_tree(random, 12, 0.2, 30.0, 1.2);
        SceneSettings settings;
        settings.integrator = integrator;
        const auto scene = make_scene(plan, {}, settings);
        allocations = 0;
        for (int tick = 0; tick < 300; ++tick) {
            flail(*scene, plan, 3.0);
            counting = true;
            static_cast<void>(scene->advance(kTestTick));
            counting = false;
        }
        CHECK(scene->audit().events > 0);
        CHECK(allocations == 0);
    }
}

TEST_CASE("the allocation counter counts", "[dynamics][allocation]") {
    allocations = 0;
    counting = true;
    const auto* number = new volatile int(3);
    counting = false;
    delete number;
    CHECK(allocations == 1);
}
