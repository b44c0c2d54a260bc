#include "dynamics/bodies.h"
#include "golden/audit.h"
#include "golden/golden.h"
#include "support/workload.h"

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
}

}  // namespace cambrian::golden
