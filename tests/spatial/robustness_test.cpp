#include "math/elementary.h"
#include "spatial/bodies.h"

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

bool is_honest(const SceneAudit& audit) {
    return std::fabs(audit.energy_residual) <= 0.05 * audit.energy_scale &&
           audit.positive_work <= 0.1 * audit.energy_scale;
}

// Section 15.3 of the design, with fewer creatures.
struct Trials {
    std::uint64_t seed = 0;
    int parts = 0;
    int creatures = 0;
    Environment environment;
    double fastest = 1.0;  // Hz, of the targets
};

// Runs random creatures for 5 s and checks what physics must hold.
void run_trials(const Trials& trials) {
    double seconds = 0.0;
    double most_evaluations = 0.0;
    double deepest = 0.0;
    double overrun = 0.0;
    double residual = 0.0;
    double work = 0.0;
    std::uint64_t evaluations = 0;
    std::uint64_t steps = 0;
    std::uint64_t fallbacks = 0;
    int suspect = 0;
    for (int creature = 0; creature < trials.creatures; ++creature) {
        RandomStream random(stream_seed({trials.seed, static_cast<std::uint64_t>(trials.parts),
                                         static_cast<std::uint64_t>(creature)}));
        const BodyPlan plan = random_solid(random, trials.parts, creature % 2 == 0 ? 25e3 : 100e3);
        constexpr double kFrictions[] = {0.0, 0.4, 0.8, 1.2};
        constexpr double kElasticities[] = {0.0, 0.3, 0.6};
        Environment environment = trials.environment;
        environment.friction = kFrictions[creature % 4];
        environment.elasticity = kElasticities[creature % 3];
        const auto scene = make_solid(plan, environment);
        if (environment.has_ground) stand(*scene);
        constexpr double duration = 5.0;
        while (scene->time() < duration) {
            swing(*scene, plan, trials.fastest);
            INFO(trials.parts << " parts, creature " << creature << " at " << scene->time());
            REQUIRE(scene->advance(1.0 / 60) == SceneStatus::kRunning);
        }
        const SceneAudit& audit = scene->audit();
        seconds += duration;
        evaluations += audit.evaluations;
        steps += audit.steps;
        fallbacks += audit.fallbacks;
        most_evaluations =
            std::fmax(most_evaluations, static_cast<double>(audit.evaluations) / duration);
        deepest = std::fmax(deepest, audit.max_penetration);
        overrun = std::fmax(overrun, audit.max_limit_overrun);
        const double scale = std::fmax(audit.energy_scale, 1e-9) * trials.creatures;
        residual += std::fabs(audit.energy_residual) / scale;
        work += audit.positive_work / scale;
        suspect += is_honest(audit) ? 0 : 1;
    }
    const std::string figures = fmt::format(
        "{} parts, {} creatures: {:.0f} evaluations/s, most {:.0f}, {:.0f} steps/s, {:.2f} % "
        "of the problems open; residual {:.1e}, positive work {:.2f} %, {:.1f} mm deep, "
        "overrun {:.3f}, {} suspect",
        trials.parts, trials.creatures, static_cast<double>(evaluations) / seconds,
        most_evaluations, static_cast<double>(steps) / seconds,
        100.0 * static_cast<double>(fallbacks) / static_cast<double>(steps), residual, 100.0 * work,
        1e3 * deepest, overrun, suspect);
    INFO(figures);
    CHECK(most_evaluations < 1500.0);
    CHECK(deepest < 0.05);
    CHECK(overrun < 0.1);
    CHECK(suspect <= trials.creatures / 20);
}

Environment with_self_contact(Environment environment) {
    environment.self_contact = true;
    return environment;
}

void run_touching(int parts, int creatures) {
    for (const Environment& environment : {weightless(), spatial_water(), spatial_ground(0.8, 0.2)})
        run_trials({.seed = 116,
                    .parts = parts,
                    .creatures = creatures,
                    .environment = with_self_contact(environment)});
}

}  // namespace

TEST_CASE("Random creatures on the ground never break physics") {
    for (const int parts : {3, 6, 12, 24})
        run_trials({.seed = 113,
                    .parts = parts,
                    .creatures = parts < 24 ? 60 : 20,
                    .environment = spatial_ground(0.8, 0.2)});
}

TEST_CASE("Random creatures in space whose parts touch never break physics") {
    for (const int parts : {3, 6, 12, 24})
        run_touching(parts, parts < 24 ? 40 : 20);
}

// Its contacts need steps without rows, in which one joint turns at 80 rad/s.
TEST_CASE("A fast joint in space does not leave its stop behind while contacts are not solved") {
    RandomStream random(stream_seed({659, 93}));
    const int parts = random.between(3, 32);
    const double strength = random.uniform(25e3, 100e3);
    const double fastest = random.uniform(2.0, 6.0);
    const BodyPlan plan = random_solid(random, parts, strength);
    const auto scene = make_solid(plan, with_self_contact(spatial_ground(0.0, 0.6)));
    stand(*scene);
    while (scene->time() < 0.6) {
        swing(*scene, plan, fastest);
        run_ticks(*scene, 1);
    }
    CAPTURE(parts, scene->audit().events);
    CHECK(scene->audit().max_limit_overrun < 0.05);
}

TEST_CASE("Random creatures in water never break physics") {
    double overrun = 0.0;
    double residual = 0.0;
    for (std::uint64_t creature = 0; creature < 40; ++creature) {
        RandomStream random(stream_seed({116, creature}));
        const int parts = random.between(3, 20);
        const BodyPlan plan = random_solid(random, parts, creature % 2 == 0 ? 25e3 : 100e3);
        const auto scene = make_solid(plan, spatial_water());
        while (scene->time() < 5.0) {
            swing(*scene, plan);
            INFO(parts << " parts, creature " << creature << " at " << scene->time());
            REQUIRE(scene->advance(1.0 / 60) == SceneStatus::kRunning);
        }
        const SceneAudit& audit = scene->audit();
        CHECK(is_honest(audit));
        overrun = std::fmax(overrun, audit.max_limit_overrun);
        residual = std::fmax(residual, std::fabs(audit.energy_residual) / audit.energy_scale);
    }
    CAPTURE(overrun, residual);
    CHECK(overrun < 0.1);
    CHECK(residual < 0.05);
}

TEST_CASE("Creatures in space that hold a pose come to rest") {
    for (const int parts : {3, 6, 12}) {
        constexpr int creatures = 20;
        int at_rest = 0;
        std::uint64_t evaluations = 0;
        for (std::uint64_t creature = 0; creature < creatures; ++creature) {
            RandomStream random(stream_seed({114, static_cast<std::uint64_t>(parts), creature}));
            const BodyPlan plan = random_solid(random, parts, 25e3);
            const auto scene = make_solid(plan, spatial_ground(0.8, 0.2));
            stand(*scene);
            double fastest = 0.0;
            for (int tick = 0; tick < 600; ++tick) {
                REQUIRE(scene->advance(1.0 / 60) == SceneStatus::kRunning);
                if (tick < 540) continue;
                for (std::size_t p = 0; p < plan.parts.size(); ++p)
                    fastest = std::fmax(fastest, scene->part_twist(p).linear.norm());
            }
            evaluations += scene->audit().evaluations;
            at_rest += fastest < 1e-3 ? 1 : 0;
        }
        const std::string figures =
            fmt::format("{} parts: {} of {} at rest after 9 s, {} evaluations/s", parts, at_rest,
                        creatures, evaluations / (10 * creatures));
        INFO(figures);
        CHECK(at_rest >= creatures - (parts == 3 ? 0 : 1));
    }
}

}  // namespace cambrian
