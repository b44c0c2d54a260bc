#include "creature/body_plan_hash.h"

#include "support/catch.h"

using namespace cambrian;

namespace {

constexpr JointMotion kFixed = JointMotion::kFixed;
constexpr JointMotion kTurn = JointMotion::kTurn;
constexpr JointMotion kSlide = JointMotion::kSlide;

// Returns the hash of parts given by (parent, joint), in this order.
std::uint64_t hash_of(const std::vector<std::pair<int, JointMotion>>& parts, double size = 1.0) {
    Phenotype phenotype;
    for (const auto& [parent, joint] : parts) {
        PlannedPart part;
        part.parent = parent;
        part.motion = joint;
        part.half_extents = Vec3(size, 0.5 * size, 0.0);
        phenotype.plan.parts.push_back(part);
    }
    return body_plan_hash(phenotype);
}

}  // namespace

TEST_CASE("a body plan is its tree of parts and joints, whatever sizes and order",
          "[creature][body_plan]") {
    // The plan has a root with one limb of two parts and one of one part.
    const auto plan = hash_of({{-1, kFixed}, {0, kTurn}, {1, kTurn}, {0, kSlide}});
    CHECK(plan == hash_of({{-1, kFixed}, {0, kTurn}, {1, kTurn}, {0, kSlide}}, 0.3));
    CHECK(plan ==
          hash_of({{-1, kTurn}, {0, kTurn}, {1, kTurn}, {0, kSlide}}));  // the root has no joint
    CHECK(plan == hash_of({{-1, kFixed}, {0, kSlide}, {0, kTurn}, {2, kTurn}}));
    CHECK(plan != hash_of({{-1, kFixed}, {0, kTurn}, {1, kTurn}, {0, kTurn}}));
    CHECK(plan != hash_of({{-1, kFixed}, {0, kTurn}, {1, kTurn}, {1, kSlide}}));
    CHECK(plan != hash_of({{-1, kFixed}, {0, kTurn}, {1, kTurn}}));
    CHECK(hash_of({{-1, kFixed}}) != hash_of({{-1, kFixed}, {0, kFixed}}));
}

TEST_CASE("a deformable part is another body plan", "[creature][body_plan]") {
    Phenotype rigid;
    rigid.plan.parts.emplace_back();
    Phenotype deformable = rigid;
    deformable.plan.parts[0].stretch = PlannedStretch{-0.3, 0.3, 1.0, 1.5};
    CHECK(body_plan_hash(deformable) != body_plan_hash(rigid));
}
