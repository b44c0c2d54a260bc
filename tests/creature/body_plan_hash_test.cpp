#include "creature/body_plan_hash.h"

#include "support/catch.h"

using namespace cambrian;

namespace {

// Parts by (parent, joint), in this order.
std::uint64_t hash_of(const std::vector<std::pair<int, std::uint8_t>>& parts, double size = 1.0) {
    Phenotype phenotype;
    for (const auto& [parent, joint] : parts) {
        PlannedPart part;
        part.parent = parent;
        part.joint_kind = joint;
        part.half_extents = Vec3(size, 0.5 * size, 0.0);
        phenotype.plan.parts.push_back(part);
    }
    return body_plan_hash(phenotype);
}

}  // namespace

TEST_CASE("a body plan is its tree of parts and joints, whatever sizes and order",
          "[creature][body_plan]") {
    // A root with a limb of two and a limb of one.
    const auto plan = hash_of({{-1, 0}, {0, 1}, {1, 1}, {0, 2}});
    CHECK(plan == hash_of({{-1, 0}, {0, 1}, {1, 1}, {0, 2}}, 0.3));
    CHECK(plan == hash_of({{-1, 1}, {0, 1}, {1, 1}, {0, 2}}));  // the root has no joint
    CHECK(plan == hash_of({{-1, 0}, {0, 2}, {0, 1}, {2, 1}}));
    CHECK(plan != hash_of({{-1, 0}, {0, 1}, {1, 1}, {0, 1}}));
    CHECK(plan != hash_of({{-1, 0}, {0, 1}, {1, 1}, {1, 2}}));
    CHECK(plan != hash_of({{-1, 0}, {0, 1}, {1, 1}}));
    CHECK(hash_of({{-1, 0}}) != hash_of({{-1, 0}, {0, 0}}));
}
