// Properties of every expressed genome, tested on founders and their descendants.

#include "brain/lazy_brain.h"
#include "breeding/disconnected_neurons.h"
#include "breeding/mutation.h"
#include "creature/builders.h"
#include "creature/creature.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

std::vector<Genome> founders(std::size_t count) {
    std::vector<Genome> genomes;
    for (std::size_t i = 0; i < count; ++i) {
        RandomStream stream(stream_seed(3, 0, i, Purpose::kTest));
        genomes.push_back(random_genome({}, kinds().catalog, stream));
    }
    return genomes;
}

std::vector<Genome> evolved(std::size_t count) {
    const MutationRegistry mutations = builtin_mutations();
    const FounderSettings settings = {.joints = {{"linear", true}}};
    std::vector<Genome> genomes = founders(count);
    for (std::size_t i = 0; i < count; ++i) {
        RandomStream stream(stream_seed(4, 0, i, Purpose::kTest));
        mutate(genomes[i], {.rate = 40.0}, mutations, {kinds().catalog, settings}, stream);
    }
    return genomes;
}

void check_limits(const Phenotype& body, const ExpressionSettings& limits) {
    REQUIRE(body.parts.size() <= static_cast<std::size_t>(limits.max_parts));
    REQUIRE(body.network.neurons.size() <= static_cast<std::size_t>(limits.max_neurons));
    REQUIRE(body.plan.parts.size() == body.parts.size());
    for (std::size_t i = 0; i < body.parts.size(); ++i) {
        const BodyPart& part = body.parts[i];
        const PlannedPart& plan = body.plan.parts[i];
        REQUIRE(part.depth <= limits.max_depth);
        REQUIRE(part.parent < static_cast<int>(i));
        REQUIRE(part.length >= gene_range::kMinSize);
        REQUIRE(part.length <= gene_range::kMaxLength);
        REQUIRE(part.width <= gene_range::kMaxWidth);
        REQUIRE(plan.limit_low <= 0.0);
        REQUIRE(plan.limit_high >= 0.0);
        if (part.parent < 0) continue;
        const PlannedPart& parent = body.plan.parts[static_cast<std::size_t>(part.parent)];
        const Vec3 here = transform(plan.rest_pose, plan.anchor_in_child);
        REQUIRE((here - transform(parent.rest_pose, plan.anchor_in_parent)).norm() < 1e-9);
    }
}

// Checks that both brains agree bit for bit on random readings. Returns whether they met a cycle.
bool agrees_with_lazy(const Phenotype& body, int ticks, RandomStream& stream) {
    Brain brain(body.network, kinds().functions);
    LazyBrain lazy(body.network, kinds().functions);
    for (int tick = 0; tick < ticks; ++tick) {
        for (std::size_t s = 0; s < body.network.sensor_count; ++s)
            brain.sensors()[s] = lazy.sensors()[s] = stream.uniform(-1.5, 1.5);
        brain.think(1.0 / 60.0);
        lazy.think(1.0 / 60.0);
        for (std::size_t o = 0; o < body.network.outputs.size(); ++o)
            REQUIRE(brain.output(o) == lazy.output(o));
    }
    return lazy.cycle_reads() > 0;
}

// Returns the genome's body at the far end of a new root, reflected or not.
Genome carried(const Genome& genome, bool reflect) {
    Genome carrier = genome;
    for (NodeGene& node : carrier.nodes) {
        for (EdgeGene& edge : node.edges)
            ++edge.target;
    }
    EdgeGene edge = edge_to(1);
    edge.reflect = reflect;
    carrier.nodes.insert(carrier.nodes.begin(), node_with({edge}));
    carrier.root_angle = 0.0;
    return carrier;
}

bool turns(const PlannedPart& part) {
    return part.motion == JointMotion::kTurn;
}

void check_mirrored(const Phenotype& body, const Phenotype& mirrored) {
    REQUIRE(mirrored.parts.size() == body.parts.size());
    for (std::size_t i = 1; i < body.parts.size(); ++i) {
        const PlannedPart& part = body.plan.parts[i];
        const PlannedPart& image = mirrored.plan.parts[i];
        const Vec3 position = part.rest_pose.position.cwiseProduct(Vec3(1, -1, 1));
        REQUIRE((image.rest_pose.position - position).norm() < 1e-9);
        REQUIRE(image.rest_angle == Approx(-part.rest_angle).margin(1e-9));
        REQUIRE(image.limit_low == (turns(part) ? -part.limit_high : part.limit_low));
    }
}

// Both bodies act on random readings, which are mirrored for the second.
void check_mirrored_motion(const Phenotype& body, const Phenotype& mirrored, RandomStream& stream) {
    const SceneSettings settings;
    Creature left(body, kinds(), settings);
    Creature right(mirrored, kinds(), settings);
    FakeScene left_scene(body.parts.size());
    FakeScene right_scene(body.parts.size());
    const auto sign = [&](std::size_t part) { return turns(body.plan.parts[part]) ? -1.0 : 1.0; };
    for (int tick = 0; tick < 20; ++tick) {
        for (std::size_t part = 1; part < body.parts.size(); ++part) {
            left_scene.coordinates[part] = stream.uniform(-1.0, 1.0);
            right_scene.coordinates[part] = sign(part) * left_scene.coordinates[part];
            for (bool& touch : left_scene.touched[part])
                touch = stream.chance(0.5);
            right_scene.touched[part] = left_scene.touched[part];
            std::swap(right_scene.touched[part][1], right_scene.touched[part][3]);
        }
        left.act(left_scene, FakeSurroundings(), 1.0 / 60.0);
        right.act(right_scene, FakeSurroundings(), 1.0 / 60.0);
        for (std::size_t part = 1; part < body.parts.size(); ++part)
            REQUIRE(right_scene.targets[part] == sign(part) * left_scene.targets[part]);
    }
}

}  // namespace

TEST_CASE("every valid genome grows within the limits, connected at its joints",
          "[creature][expression]") {
    std::vector<Genome> genomes = evolved(300);
    for (const Genome& founder : founders(300))
        genomes.push_back(founder);
    const ExpressionSettings large = {.max_parts = 32};
    const ExpressionSettings small = {.max_parts = 2, .max_depth = 1, .max_neurons = 40};
    for (const Genome& genome : genomes) {
        check_limits(express(genome), {});
        check_limits(express(genome, large), large);
        check_limits(express(genome, small), small);
    }
}

TEST_CASE("compiled brains of founders and their descendants think as the lazy rule does",
          "[creature][expression]") {
    RandomStream stream(stream_seed(5, 0, 0, Purpose::kTest));
    const auto cyclic_share = [&](const std::vector<Genome>& genomes) {
        double cyclic = 0.0;
        for (const Genome& genome : genomes)
            cyclic += agrees_with_lazy(express(genome), 200, stream);
        return cyclic / static_cast<double>(genomes.size());
    };
    const double founders_share = cyclic_share(founders(1000));
    const double evolved_share = cyclic_share(evolved(1000));
    CHECK(founders_share + evolved_share > 2 * 0.2);
}

TEST_CASE("a reflected subtree in a mirrored world does the mirrored thing",
          "[creature][expression]") {
    RandomStream stream(stream_seed(6, 0, 0, Purpose::kTest));
    std::vector<Genome> genomes = founders(150);
    for (const Genome& genome : evolved(150))
        genomes.push_back(genome);
    for (const Genome& genome : genomes) {
        if (genome.nodes.size() == gene_range::kMaxNodes) continue;
        const Phenotype body = express(carried(genome, false));
        const Phenotype mirrored = express(carried(genome, true));
        check_mirrored(body, mirrored);
        check_mirrored_motion(body, mirrored, stream);
    }
}

TEST_CASE("removing disconnected neurons never changes the compiled brain",
          "[creature][expression]") {
    RandomStream stream(stream_seed(7, 0, 0, Purpose::kTest));
    std::size_t removed = 0;
    for (const Genome& genome : evolved(500)) {
        Genome collected = genome;
        remove_disconnected_neurons(collected);
        REQUIRE(validate(collected, kinds().catalog).empty());
        const Phenotype before = express(genome);
        const Phenotype after = express(collected);
        REQUIRE(after.network.order.size() == before.network.order.size());
        REQUIRE(after.network.sensor_count == before.network.sensor_count);
        Brain first(before.network, kinds().functions);
        Brain second(after.network, kinds().functions);
        for (int tick = 0; tick < 50; ++tick) {
            for (std::size_t s = 0; s < before.network.sensor_count; ++s)
                first.sensors()[s] = second.sensors()[s] = stream.uniform(-1.5, 1.5);
            first.think(1.0 / 60.0);
            second.think(1.0 / 60.0);
            for (std::size_t o = 0; o < before.network.outputs.size(); ++o)
                REQUIRE(second.output(o) == first.output(o));
        }
        removed += before.network.neurons.size() - after.network.neurons.size();
    }
    CHECK(removed > 1000);
}

TEST_CASE("founders have a movable joint almost always and five or six parts on average",
          "[creature][expression]") {
    double parts = 0.0;
    double immovable = 0.0;
    for (const Genome& genome : founders(1000)) {
        const Phenotype body = express(genome);
        parts += static_cast<double>(body.parts.size()) / 1000.0;
        immovable += body.can_move() ? 0.0 : 1.0 / 1000.0;
    }
    CHECK(parts == Approx(5.6).margin(1.0));
    CHECK(immovable < 0.05);
}
