#include "pictures/scene/living_look.h"
#include "pictures/scene/moment.h"
#include "support/allocation_count.h"
#include "support/creatures.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

TEST_CASE("a frame with a living creature allocates nothing after the first", "[pictures][look]") {
    const GenomePtr genome = test::crawler(test::kinds().creature.catalog);
    const ExperimentSettings settings;
    const Phenotype phenotype =
        express(*genome, test::kinds().creature, settings.expression, settings.world.scene);
    std::vector<Pose> poses;
    for (const PlannedPart& part : phenotype.plan.parts)
        poses.push_back(part.rest_pose);
    const Palette palette = palette_of(ThemeKind::kDark);
    const Camera camera;
    const CreatureLook look{phenotype, poses};
    SceneFrame frame;
    add_being(frame, palette, camera, look);
    const std::size_t before = test::allocation_count();
    for (int i = 0; i < 3; ++i) {
        frame.clear();
        add_being(frame, palette, camera, look);
    }
    CHECK(test::allocation_count() == before);
    CHECK(frame.skins.size() == 1);
}

}  // namespace
}  // namespace cambrian
