#include "spatial/box_contacts.h"

#include "core/random.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

namespace cambrian::spatial {
namespace {

Vec3 vector_within(RandomStream& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

PlacedBox random_box(RandomStream& random) {
    PlacedBox box;
    box.center = vector_within(random, 0.35);
    box.axes = turn_of(rotation_by(vector_within(random, 2.0)));
    box.half = {random.uniform(0.05, 0.4), random.uniform(0.05, 0.3), random.uniform(0.05, 0.3)};
    return box;
}

Vec3 point_of(const PlacedBox& box, const Vec3& shares) {
    return box.center + box.axes * shares.cwiseProduct(box.half);
}

// Returns how deep a point is in a box, m; negative outside.
double depth_in(const PlacedBox& box, const Vec3& point) {
    return (box.half - box.axes.back(point - box.center).cwiseAbs()).minCoeff();
}

}  // namespace

TEST_CASE("Boxes in space overlap exactly when a point is in both") {
    RandomStream random(stream_seed({120}));
    int overlapping = 0;
    for (int round = 0; round < 2000; ++round) {
        const PlacedBox first = random_box(random);
        const PlacedBox second = random_box(random);
        const double gap = gap_between(first, second);
        CHECK(gap_between(second, first) == Approx(gap).margin(2e-4));
        double shared = -1.0;
        for (int point = 0; point < 200; ++point)
            shared =
                std::fmax(shared, depth_in(second, point_of(first, vector_within(random, 1.0))));
        if (shared > 0.0) {
            CHECK(gap < 0.0);
            ++overlapping;
        }
        // Boxes that a plane separates by some distance are at least that far apart.
        if (gap > 0.0) CHECK(shared < -0.57 * gap);
        CHECK((collide_boxes(first, second, 0.0).count > 0) == (gap < 0.0));
    }
    CHECK(overlapping > 500);
}

TEST_CASE("Contact points of boxes in space lie on both of them, as deep as they say") {
    RandomStream random(stream_seed({121}));
    int faces = 0;
    int edges = 0;
    for (int round = 0; round < 4000; ++round) {
        PlacedBox first = random_box(random);
        const PlacedBox second = random_box(random);
        const BoxManifold manifold = collide_boxes(first, second, 0.0);
        if (manifold.count == 0) continue;
        const PlacedBox& incident = manifold.first_is_incident ? first : second;
        const PlacedBox& reference = manifold.first_is_incident ? second : first;
        const Vec3& normal = manifold.surface.axis[0];
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b)
                CHECK(dot(manifold.surface.axis[a], manifold.surface.axis[b]) ==
                      Approx(a == b ? 1.0 : 0.0).margin(1e-12));
        }
        std::set<int> features;
        for (int p = 0; p < manifold.count; ++p) {
            const BoxPoint& point = manifold.points[p];
            CHECK(depth_in(incident, point.place) == Approx(0.0).margin(1e-12));
            CHECK(depth_in(reference, point.place - point.gap * normal) ==
                  Approx(0.0).margin(1e-12));
            CHECK(point.gap <= 0.0);
            CHECK(point.feature >= 0);
            CHECK(point.feature < kBoxFeatures);
            features.insert(point.feature);
        }
        CHECK(static_cast<int>(features.size()) == manifold.count);
        (manifold.points[0].feature < kBoxFeatures - 144 ? faces : edges) += 1;
        // Along the normal it is not far out.
        const double depth = -gap_between(first, second);
        first.center += (manifold.first_is_incident ? 1.0 : -1.0) * (1.06 * depth + 2e-4) * normal;
        CHECK(gap_between(first, second) > 0.0);
    }
    CHECK(faces > 500);
    CHECK(edges > 100);
}

TEST_CASE("A box that stands on another one touches it with the corners of its face") {
    PlacedBox floor;
    floor.half = {1.0, 0.1, 1.0};
    PlacedBox box;
    box.half = {0.2, 0.3, 0.1};
    box.center = {0.3, 0.399, -0.2};
    box.axes = turn_of(rotation_by({0.0, 0.5, 0.0}));
    for (const bool swapped : {false, true}) {
        const BoxManifold manifold =
            swapped ? collide_boxes(box, floor, 0.02) : collide_boxes(floor, box, 0.02);
        REQUIRE(manifold.count == 4);
        const double up = manifold.first_is_incident == swapped ? 1.0 : -1.0;
        CHECK(manifold.surface.axis[0].y() == Approx(up));
        Vec3 sum = Vec3::Zero();
        for (int p = 0; p < 4; ++p) {
            CHECK(manifold.points[p].gap == Approx(-0.001));
            const Vec3 arm = manifold.points[p].place - box.center;
            CHECK(std::hypot(arm.x(), arm.z()) == Approx(std::hypot(0.2, 0.1)));
            sum += arm;
        }
        CHECK(std::hypot(sum.x(), sum.z()) < 1e-12);
    }
}

TEST_CASE("Of the eight corners of two crossed squares four remain") {
    PlacedBox floor;
    floor.half = {0.2, 0.2, 0.2};
    PlacedBox box = floor;
    box.center = {0.01, 0.401, 0.02};
    box.axes = turn_of(rotation_by({0.0, 0.8, 0.0}));
    const BoxManifold manifold = collide_boxes(floor, box, 0.02);
    REQUIRE(manifold.count == 4);
    // They surround the middle.
    for (const double side : {-1.0, 1.0}) {
        for (const int axis : {0, 2}) {
            bool found = false;
            for (int p = 0; p < 4; ++p)
                found = found || side * manifold.points[p].place[axis] > 0.08;
            CHECK(found);
        }
    }
}

TEST_CASE("Two bars that cross touch where their edges pass each other") {
    const double diagonal = 0.1 * std::sqrt(2.0);
    PlacedBox lower;
    lower.half = {0.5, 0.1, 0.1};
    lower.axes = turn_of(rotation_by({0.25 * kPi, 0.0, 0.0}));
    PlacedBox upper;
    upper.half = {0.5, 0.1, 0.1};
    upper.axes =
        turn_of(product(rotation_by({0.0, 0.5 * kPi, 0.0}), rotation_by({0.25 * kPi, 0.0, 0.0})));
    for (const double gap : {-0.003, 0.005}) {
        upper.center = {0.2, 2.0 * diagonal + gap, 0.1};
        const BoxManifold manifold = collide_boxes(upper, lower, 0.02);
        REQUIRE(manifold.count == 1);
        REQUIRE(manifold.first_is_incident);
        CHECK(manifold.surface.axis[0].y() == Approx(1.0));
        CHECK(manifold.points[0].gap == Approx(gap));
        CHECK((manifold.points[0].place - Vec3(0.2, diagonal + gap, 0.0)).norm() < 1e-12);
    }
    // An edge that lies nearly flat on a face touches both of its edges and does not rock.
    PlacedBox block;
    block.half = {0.5, 0.1, 0.1};
    upper.center = {0.0, 0.1 + diagonal, 0.0};
    upper.axes = turn_of(
        product(rotation_by({0.02, 0.0, 0.0}),
                product(rotation_by({0.0, 0.5 * kPi, 0.0}), rotation_by({0.25 * kPi, 0.0, 0.0}))));
    const BoxManifold flat = collide_boxes(upper, block, 0.02);
    REQUIRE(flat.count >= 2);
    double least = 0.0;
    double most = 0.0;
    for (int p = 0; p < flat.count; ++p) {
        least = std::fmin(least, flat.points[p].place.z());
        most = std::fmax(most, flat.points[p].place.z());
    }
    CHECK(least == Approx(-0.1).margin(1e-3));
    CHECK(most == Approx(0.1).margin(1e-3));
    // Beyond the end of an edge there is nothing to touch.
    upper.center = {0.62, 2.0 * diagonal - 0.003, 0.0};
    CHECK(collide_boxes(upper, lower, 0.02).count == 0);
}

}  // namespace cambrian::spatial
