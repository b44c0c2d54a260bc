#include "golden/audit.h"
#include "golden/golden.h"
#include "planar/bodies.h"
#include "support/workload.h"
#include "world/terrain.h"

namespace cambrian::golden {
namespace {

// The number of random trees of a size and their duration. The reference integrator gets less,
// since its cost grows with the cube of the size.
struct Share {
    int parts;
    int trees;
    double duration;  // s
};

std::vector<Share> shares_of(const std::string& integrator) {
    if (integrator == SceneSettings{}.integrator)
        return {{3, 3, 3.0}, {6, 3, 3.0}, {12, 3, 3.0}, {24, 3, 3.0}};
    if (integrator == "least-squares") return {{3, 1, 1.0}, {6, 1, 0.5}, {12, 1, 0.2}};
    return {{3, 1, 3.0}, {6, 1, 3.0}, {12, 1, 3.0}, {24, 1, 3.0}};
}

void flail_for(PhysicsScene& scene, const BodyPlan& plan, double duration) {
    while (scene.status() == SceneStatus::kRunning && scene.time() < duration) {
        flail(scene, plan, 2.0);
        scene.advance(kTestTick);
    }
}

void add_scene(Hash64& hash, const PhysicsScene& scene) {
    scene.add_to_digest(hash);
    add_audit(hash, scene.audit());
}

std::uint64_t digest_of_trees(const Environment& environment, const SceneSettings& settings,
                              const Share& share) {
    Hash64 hash;
    for (int tree = 0; tree < share.trees; ++tree) {
        RandomStream random(stream_seed(
            {21, static_cast<std::uint64_t>(share.parts), static_cast<std::uint64_t>(tree)}));
        const BodyPlan plan = random_tree(random, share.parts, 0.25, 20.0, 1.2);
        const auto scene = make_scene(plan, environment, settings);
        if (environment.has_ground) stand_on_ground(*scene);
        flail_for(*scene, plan, share.duration);
        add_scene(hash, *scene);
    }
    return hash.value();
}

// Simulates a chain that curls up until its parts lie on each other.
std::uint64_t digest_of_curling(const std::string& integrator) {
    BodyPlan plan = chain(8, 1.4);
    for (PlannedPart& part : plan.parts)
        part.max_effort = 0.5;
    SceneSettings settings;
    settings.integrator = integrator;
    const auto scene = make_scene(plan, empty_space(), settings);
    for (std::size_t part = 1; part < plan.parts.size(); ++part)
        scene->set_target(part, plan.parts[part].limit_high);
    run(*scene, 2.0);
    Hash64 hash;
    add_scene(hash, *scene);
    return hash.value();
}

// Simulates trees in which every second part deforms.
std::uint64_t digest_of_deforming(const Environment& environment) {
    Hash64 hash;
    for (std::uint64_t tree = 0; tree < 3; ++tree) {
        RandomStream random(stream_seed({22, tree}));
        BodyPlan plan = random_tree(random, 8, 0.25, 10.0, 1.2);
        for (std::size_t part = 0; part < plan.parts.size(); part += 2)
            plan.parts[part].stretch = PlannedStretch{-0.4, 0.4, 1.0, 1.5};
        const auto scene = make_scene(plan, environment);
        if (environment.has_ground) stand_on_ground(*scene);
        for (int tick = 0; tick < 180; ++tick) {
            for (std::size_t part = 0; part < plan.parts.size(); part += 2)
                scene->set_stretch_target(part, (tick / 30) % 2 == 0 ? 0.4 : -0.4);
            flail(*scene, plan, 2.0);
            scene->advance(kTestTick);
        }
        add_scene(hash, *scene);
    }
    return hash.value();
}

// Simulates trees on ground with a shape, and the shape itself.
std::uint64_t digest_of_terrain(const std::string& kind) {
    Environment environment;
    TerrainSettings& terrain = environment.terrain;
    terrain = {kind, 0.2, 0.5, 0.4, 3.0, 1.0, kind == "hills" ? "different" : "mirrored"};
    terrain.points = "-5 0.5; 0 0; 1 0.2; 1 0.4; 2 0.4; 2.5 -0.3; 9 0.6";
    Hash64 hash;
    const auto ground = Terrain::make(terrain);
    for (double x = -80.0; x < 80.0; x += 0.37)
        hash.add((*ground)->height(x));
    for (std::uint64_t tree = 0; tree < 3; ++tree) {
        RandomStream random(stream_seed({23, tree}));
        const BodyPlan plan = random_tree(random, 8, 0.25, 20.0, 1.2);
        const auto scene = make_scene(plan, environment);
        scene->translate(Vec3(2.0 - scene->center_of_mass().x(), 0.0, 0.0));
        scene->translate(Vec3(0.0, 0.02 - scene->ground_gap(), 0.0));
        flail_for(*scene, plan, 3.0);
        add_scene(hash, *scene);
    }
    return hash.value();
}

}  // namespace

void add_physics_digests(Digests& digests) {
    for (const Workload& workload : all_workloads()) {
        for (const IntegratorName& name : planar_scene_kind().integrators) {
            const std::string& integrator = name.id;
            SceneSettings settings;
            settings.integrator = integrator;
            for (const Share& share : shares_of(integrator)) {
                digests.push_back({"physics." + workload.id + "." + integrator + "." +
                                       std::to_string(share.parts),
                                   digest_of_trees(workload.environment, settings, share)});
            }
        }
    }
    for (const char* integrator : {"bogacki-shampine", "semi-implicit"})
        digests.push_back(
            {std::string("physics.curl.") + integrator, digest_of_curling(integrator)});
    for (const Workload& workload : all_workloads())
        digests.push_back(
            {"physics.deforming." + workload.id, digest_of_deforming(workload.environment)});
    for (const std::string_view kind : kTerrainIds) {
        if (kind != "flat")
            digests.push_back(
                {"physics.terrain." + std::string(kind), digest_of_terrain(std::string(kind))});
    }
}

}  // namespace cambrian::golden
