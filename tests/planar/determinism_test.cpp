#include "core/threads/thread_pool.h"
#include "planar/bodies.h"
#include "planar/scene_copies.h"
#include "support/catch.h"

#include <vector>

using namespace cambrian;

namespace {

BodyPlan walker(std::uint64_t seed) {
    RandomStream random(stream_seed({seed, 11}));
    return random_tree(random, 6, 0.2, 20.0, 1.2);
}

void walk(PhysicsScene& scene, const BodyPlan& plan, int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
        flail(scene, plan, 2.0);
        REQUIRE(scene.advance(kTestTick) == SceneStatus::kRunning);
    }
}

std::uint64_t digest_of(const PhysicsScene& scene) {
    Hash64 digest;
    scene.add_to_digest(digest);
    return digest.value();
}

}  // namespace

TEST_CASE("the same walk gives the same bits", "[dynamics][determinism]") {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const BodyPlan plan = walker(seed);
        const auto first = make_scene(plan, {});
        const auto second = make_scene(plan, {});
        walk(*first, plan, 200);
        walk(*second, plan, 200);
        CHECK(digest_of(*first) == digest_of(*second));
    }
}

TEST_CASE("every copy of the code deforms with the same bits", "[dynamics][determinism]") {
    BodyPlan plan = walker(8);
    for (PlannedPart& part : plan.parts)
        part.stretch = PlannedStretch{-0.3, 0.4, 1.0, 1.5};
    std::vector<std::uint64_t> digests;
    for (const SceneCopy& copy : scene_copies()) {
        const auto scene = copy.make(plan, {}, {});
        for (std::size_t part = 0; part < plan.parts.size(); ++part)
            (*scene)->set_stretch_target(part, 0.3);
        walk(**scene, plan, 60);
        digests.push_back(digest_of(**scene));
    }
    CHECK(digests == std::vector<std::uint64_t>(digests.size(), digests.front()));
}

TEST_CASE("every copy of the code gives the same bits", "[dynamics][determinism]") {
    const std::vector<SceneCopy> copies = scene_copies();
    REQUIRE(!copies.empty());
    for (const IntegratorName& integrator : planar_scene_kind().integrators) {
        INFO(integrator.id);
        SceneSettings settings;
        settings.integrator = integrator.id;
        const BodyPlan plan = walker(7);
        std::vector<std::uint64_t> digests;
        for (const SceneCopy& copy : copies) {
            const auto scene = copy.make(plan, {}, settings);
            walk(**scene, plan, 60);
            digests.push_back(digest_of(**scene));
        }
        CHECK(digests == std::vector<std::uint64_t>(copies.size(), digests.front()));
    }
}

TEST_CASE("any number of threads gives the same bits", "[dynamics][determinism][threads]") {
    constexpr std::size_t kCreatures = 64;
    const auto digests_on = [](std::size_t threads) {
        std::vector<std::uint64_t> digests(kCreatures);
        ThreadPool pool(threads);
        pool.parallel_for(kCreatures, [&](std::size_t index, std::size_t) {
            const BodyPlan plan = walker(index);
            const auto scene = planar_scene_kind().make(plan, {}, {});
            for (int tick = 0; tick < 120; ++tick) {
                flail(**scene, plan, 2.0);
                static_cast<void>((*scene)->advance(kTestTick));
            }
            digests[index] = digest_of(**scene);
        });
        return digests;
    };
    const std::vector<std::uint64_t> alone = digests_on(1);
    CHECK(digests_on(1) == alone);
    CHECK(digests_on(2) == alone);
    CHECK(digests_on(8) == alone);
}

TEST_CASE("a restored scene goes on with the same bits", "[dynamics][determinism]") {
    const BodyPlan plan = walker(3);
    const auto scene = make_scene(plan, {});
    walk(*scene, plan, 90);
    const auto saved = scene->save();
    walk(*scene, plan, 90);
    const auto other = make_scene(plan, {});
    other->restore(*saved);
    CHECK(other->time() == Approx(1.5));
    walk(*other, plan, 90);
    CHECK(digest_of(*other) == digest_of(*scene));
    CHECK(other->audit().motor_work == scene->audit().motor_work);
}

TEST_CASE("a scene with a past of its own goes on from another's state",
          "[dynamics][determinism]") {
    const BodyPlan plan = walker(3);
    const auto scene = make_scene(plan, {});
    stand_on_ground(*scene);
    walk(*scene, plan, 90);
    const auto saved = scene->save();
    walk(*scene, plan, 90);
    const auto other = make_scene(plan, {});
    other->translate(Vec3(0.0, 5.0, 0.0));
    walk(*other, plan, 90);
    other->restore(*saved);
    walk(*other, plan, 90);
    CHECK(digest_of(*other) == digest_of(*scene));
}

TEST_CASE("looking at a scene does not change its motion", "[dynamics][determinism]") {
    const BodyPlan plan = walker(4);
    const auto watched = make_scene(plan, {});
    const auto alone = make_scene(plan, {});
    std::vector<SceneContact> contacts;
    for (int i = 0; i < 20; ++i) {
        walk(*watched, plan, 5);
        watched->list_contacts(contacts);
        static_cast<void>(watched->bounds());
        static_cast<void>(watched->save());
    }
    walk(*alone, plan, 100);
    CHECK(digest_of(*watched) == digest_of(*alone));
}
