#include "creature/creature.h"

#include "creature/builders.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

constexpr double kTick = 1.0 / 60.0;

Genome two_parts(const InputGene& effector) {
    NodeGene tip;
    tip.effector = effector;
    return genome_of({node_with({edge_to(1)}), tip});
}

InputGene local_sensor(int channel, double weight = 1.0) {
    return {{SourceKind::kLocalSensor, static_cast<std::uint8_t>(channel)}, weight};
}

// Returns the last part's target after the creature acted for a while on a scene at rest.
double final_target(const Genome& genome, FakeScene& scene) {
    const Phenotype phenotype = express(genome);
    const SceneSettings settings;
    Creature creature(phenotype, kinds(), settings);
    for (int tick = 0; tick < 600; ++tick)
        creature.act(scene, FakeSurroundings(), kTick);
    return scene.targets.back();
}

}  // namespace

TEST_CASE("a pair of oscillating legs moves in opposite directions, within the limits",
          "[creature]") {
    const Phenotype phenotype = express(two_legs());
    const SceneSettings settings;
    Creature creature(phenotype, kinds(), settings);
    FakeScene scene(3);
    double greatest = 0.0;
    for (int tick = 0; tick < 300; ++tick) {
        creature.act(scene, FakeSurroundings(), kTick);
        REQUIRE(scene.targets[2] == -scene.targets[1]);
        REQUIRE(scene.targets[1] >= -0.4);
        greatest = std::fmax(greatest, scene.targets[1]);
    }
    CHECK(greatest > 0.5);
}

TEST_CASE("a constant effector settles at its value, held to the joint's limits", "[creature]") {
    FakeScene scene(2);
    CHECK(final_target(two_parts(constant(0.6)), scene) == Approx(0.6));
    CHECK(final_target(two_parts(constant(-3.0)), scene) == Approx(-1.0));
}

TEST_CASE("the motor target approaches with the time constant of the muscle", "[creature]") {
    const Phenotype phenotype = express(two_parts(constant(1.0)));
    const SceneSettings settings;
    Creature creature(phenotype, kinds(), settings);
    FakeScene scene(2);
    for (int tick = 1; tick <= 6; ++tick)
        creature.act(scene, FakeSurroundings(), kTick);
    CHECK(scene.targets[1] == Approx(1.0 - std::exp(-1.0)));
}

TEST_CASE("a mirrored part feels and moves as its partner does, mirrored", "[creature]") {
    Genome genome = two_legs();
    genome.nodes[1].effector = local_sensor(0, 0.5);
    FakeScene scene(3);
    scene.coordinates = {0.0, 0.8, -0.8};
    CHECK(final_target(genome, scene) == Approx(-0.4));
    CHECK(scene.targets[1] == Approx(0.4));
}

TEST_CASE("left and right contact are exchanged on a mirrored part", "[creature]") {
    Genome genome = two_legs();
    genome.nodes[1].effector = local_sensor(2, 0.3);
    FakeScene scene(3);
    scene.touched[1][static_cast<std::size_t>(Face::kLeft)] = true;
    scene.touched[2][static_cast<std::size_t>(Face::kRight)] = true;
    CHECK(final_target(genome, scene) == Approx(-0.3));
    CHECK(scene.targets[1] == Approx(0.3));
    scene.touched[2] = {false, true, false, false};
    CHECK(final_target(genome, scene) == Approx(0.3));
}

TEST_CASE("a sliding joint is read and driven in lengths of its part, mirrored or not",
          "[creature]") {
    Genome genome = two_legs();
    genome.nodes[1].joint = 2;
    genome.nodes[1].length = 0.5;
    genome.nodes[1].effector = local_sensor(0, 0.5);
    FakeScene scene(3);
    scene.coordinates = {0.0, 0.2, 0.2};
    CHECK(final_target(genome, scene) == Approx(0.1));
    CHECK(scene.targets[1] == Approx(0.1));
}

TEST_CASE("holding rest asks every joint for its rest coordinate", "[creature]") {
    const Phenotype phenotype = express(two_legs());
    const SceneSettings settings;
    const Creature creature(phenotype, kinds(), settings);
    FakeScene scene(3);
    scene.targets = {7.0, 7.0, 7.0};
    creature.hold_rest(scene);
    CHECK(scene.targets == std::vector<double>{7.0, 0.0, 0.0});
}

TEST_CASE("a restored creature repeats what it did, a reset one starts again", "[creature]") {
    const Phenotype phenotype = express(two_legs());
    const SceneSettings settings;
    Creature creature(phenotype, kinds(), settings);
    FakeScene scene(3);
    const auto run = [&] {
        for (int tick = 0; tick < 20; ++tick)
            creature.act(scene, FakeSurroundings(), kTick);
        return scene.targets[1];
    };
    const double first = run();
    const Creature::State state = creature.save();
    const double second = run();
    creature.restore(state);
    CHECK(run() == second);
    creature.reset();
    CHECK(run() == first);
    CHECK(first != second);
}

namespace {

std::size_t channel(std::string_view id) {
    const auto& channels = kinds().catalog.channels;
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [id](const ChannelEntry& entry) { return entry.id == id; });
    REQUIRE(found != channels.end());
    return static_cast<std::size_t>(found - channels.begin());
}

}  // namespace

TEST_CASE("what sensors remember is saved, restored and forgotten", "[creature]") {
    const Phenotype phenotype =
        express(two_parts(local_sensor(static_cast<int>(channel("accel-along")))));
    const SceneSettings settings;
    Creature creature(phenotype, kinds(), settings);
    FakeScene scene(2);
    scene.specific_forces[1] = {9.81, 0.0, 0.0};
    const FakeSurroundings surroundings;
    const auto act = [&] {
        creature.act(scene, surroundings, kTick);
        return creature.reading(0, scene, surroundings);
    };
    const double first = act();
    CHECK(first == Approx(1.0 - std::exp(-kTick / 0.05)));
    const Creature::State state = creature.save();
    const double second = act();
    CHECK(creature.reading(0, scene, surroundings) == second);
    CHECK(second > first);
    creature.restore(state);
    CHECK(act() == second);
    creature.reset();
    CHECK(act() == first);
}

TEST_CASE("physics measures forces only for a creature that feels them", "[creature]") {
    for (const ChannelEntry& entry : kinds().catalog.channels) {
        INFO(entry.id);
        const bool feels = entry.id.starts_with("accel-") || entry.id == "load";
        const int number = static_cast<int>(channel(entry.id));
        const BodyPlan plan = express(two_parts(local_sensor(number))).plan;
        CHECK(!plan.parts[0].measures_forces);
        CHECK(plan.parts[1].measures_forces == feels);
    }
}
