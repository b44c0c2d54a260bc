#include "creature/overlap.h"

#include "math/pose.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

PlannedPart box(double x, double y, double angle, int parent) {
    PlannedPart part;
    part.half_extents = Vec3(0.5, 0.1, 0.1);
    part.rest_pose = planar_pose(x, y, angle);
    part.rest_angle = angle;
    part.parent = parent;
    return part;
}

}  // namespace

TEST_CASE("parts overlap if no joint ties them and no line keeps them apart", "[creature]") {
    CHECK_FALSE(overlaps_itself({{box(0, 0, 0, -1), box(0.5, 0, 0, 0)}}));
    CHECK(overlaps_itself({{box(0, 0, 0, -1), box(0, 3, 0, 0), box(0.5, 0, 0, 1)}}));
    CHECK_FALSE(overlaps_itself({{box(0, 0, 0, -1), box(0, 3, 0, 0), box(1.01, 0, 0, 1)}}));
    // The first pair crosses at a right angle. The second is side by side at a slant, where only
    // the bounding boxes overlap.
    CHECK(overlaps_itself({{box(0, 0, 0, -1), box(0, 3, 0, 0), box(0, 0.2, 1.57, 1)}}));
    CHECK_FALSE(overlaps_itself({{box(0, 0, 0.785, -1), box(0, 3, 0, 0), box(0.4, 0, 0.785, 1)}}));
}
