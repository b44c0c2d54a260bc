// The length of a body, against all pairs of its corners.
#include "simulator/length_meter.h"

#include "genome/founders/random_genome.h"
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cambrian;

namespace {

constexpr int kLengthTicks = 3;  // simulator/README.md 1

double greatest_distance(const PhysicsScene& scene) {
    std::vector<Vec3> corners;
    for (std::size_t part = 0; part < scene.part_count(); ++part) {
        const Vec3 half = scene.part_half_extents(part);
        for (const double x : {-half.x(), half.x()}) {
            for (const double y : {-half.y(), half.y()})
                corners.push_back(transform(scene.part_pose(part), Vec3(x, y, 0.0)));
        }
    }
    double greatest = 0.0;
    for (const Vec3& a : corners) {
        for (const Vec3& b : corners)
            greatest = std::max(greatest, (a - b).norm());
    }
    return greatest;
}

// Random founders, half of them with parts that stretch.
std::vector<Genome> bodies() {
    std::vector<Genome> bodies;
    RandomStream stream(stream_seed({5, 23}));
    for (const bool deform : {false, true}) {
        FounderSettings settings;
        settings.organs["deformer"] = deform;
        for (int i = 0; i < 12; ++i)
            bodies.push_back(random_genome(settings, test::kinds().creature.catalog, stream));
    }
    return bodies;
}

}  // namespace

TEST_CASE("the body length is the greatest distance of two corners", "[simulator][length]") {
    TrialWorld world;
    world.environment.gravity = 0.0;
    world.environment.has_ground = false;
    world.environment.viscosity_quadratic = 1.0;
    world.trial.duration = 4.0;
    world.trial.stop_at_rest = false;
    int grown = 0;
    for (const Genome& genome : bodies()) {
        auto trial = Trial::start(std::make_shared<const Phenotype>(
                                      express(genome, test::creature_kinds(), {}, world.scene)),
                                  test::creature_kinds(), world);
        REQUIRE(trial);
        const double rest = (*trial)->phenotype().rest_length();
        double measured = std::max(rest, greatest_distance((*trial)->scene()));
        double greatest = measured;
        int ticks = 0;
        for (bool more = true; more;) {
            more = (*trial)->tick();
            const double present = greatest_distance((*trial)->scene());
            greatest = std::max(greatest, present);
            if (++ticks % kLengthTicks == 0) measured = std::max(measured, present);
            CHECK((*trial)->record().body_length == Approx(measured).epsilon(1e-12));
        }
        CHECK(measured >= 0.98 * greatest);
        grown += greatest > 1.02 * rest ? 1 : 0;
    }
    CHECK(grown > 5);
}
