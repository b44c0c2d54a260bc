#include "preserve/world/food.h"

#include "core/random.h"
#include "support/catch.h"

#include <algorithm>
#include <numeric>

namespace cambrian {
namespace {

const WorldArea kArea{10.0, 8.0};

Energy sum_of(std::span<const Pellet> pellets) {
    return std::accumulate(pellets.begin(), pellets.end(), Energy{0},
                           [](Energy sum, const Pellet& each) { return sum + each.energy; });
}

TEST_CASE("a mouth takes exactly the pellets within its reach", "[preserve]") {
    RandomStream random(stream_seed({2, static_cast<std::uint64_t>(Purpose::kTest)}));
    Food pellets(kArea);
    std::vector<Pellet> expected;
    for (int round = 0; round < 500; ++round) {
        for (int i = 0; i < 4; ++i) {
            const Vec3 place(random.uniform(-5.0, 5.0), random.uniform(-4.0, 4.0), 0.0);
            pellets.add(place, 1 + static_cast<Energy>(random.below(1000)));
        }
        const double turn = random.uniform(0.0, 1.5);
        const Rectangle mouth{Vec3(random.uniform(-6.0, 6.0), random.uniform(-5.0, 5.0), 0.0),
                              Vec3(1.0, turn, 0.0).normalized(), 0.6, 0.2};
        std::vector<Energy> near;
        for (const Pellet& each : pellets.all()) {
            if (distance_to(mouth, each.place()) <= 0.1) near.push_back(each.energy);
        }
        const Energy before = pellets.energy();
        const auto taken = pellets.take(mouth, 0.1);
        REQUIRE(taken.size() == near.size());
        for (std::size_t i = 0; i < near.size(); ++i)
            CHECK(taken[i].energy == near[i]);
        CHECK(pellets.energy() == before - sum_of(taken));
        CHECK(pellets.energy() == sum_of(pellets.all()));
    }
    CHECK(pellets.all().size() < 2000);
}

TEST_CASE("pellets are taken until they make up an energy", "[preserve]") {
    Food pellets(kArea);
    for (int i = 0; i < 5; ++i)
        pellets.add({static_cast<double>(i) - 2.0, 0.0, 0.0}, 10);
    CHECK(pellets.take_at_least(0) == 0);
    CHECK(pellets.take_at_least(11) == 20);
    CHECK(pellets.energy() == 30);
    REQUIRE(pellets.all().size() == 3);
    CHECK(pellets.all().back().x == 0.0);
    CHECK(pellets.take({Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.0, 0.0), 0.2, 0.2}, 0.1).empty());
    CHECK(pellets.take_at_least(1000) == 30);
    CHECK(pellets.all().empty());
    CHECK(pellets.take_at_least(1) == 0);
}

TEST_CASE("where edges meet, a mouth reaches pellets across them", "[preserve][edges]") {
    RandomStream random(stream_seed({4, static_cast<std::uint64_t>(Purpose::kTest)}));
    const WorldArea area{10.0, 8.0, false, true};
    Food pellets(area);
    for (int round = 0; round < 300; ++round) {
        for (int i = 0; i < 4; ++i)
            pellets.add({random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0), 0.0}, 7);
        const Rectangle mouth{Vec3(random.uniform(-40.0, 40.0), random.uniform(-40.0, 40.0), 0.0),
                              Vec3(1.0, random.uniform(-1.0, 1.0), 0.0).normalized(), 0.6, 0.2};
        std::size_t near = 0;
        for (const Pellet& each : pellets.all()) {
            CHECK(area.contains(each.place()));
            const Vec3 way = area.torus().shortest(each.place() - mouth.center);
            near += distance_to(mouth, mouth.center + way) <= 0.1 ? 1U : 0U;
        }
        CHECK(pellets.take(mouth, 0.1).size() == near);
    }
    Food flesh(area);
    flesh.add_near({4.95, 0.0, 0.0}, 5, 0.25);
    flesh.add_near({-4.9, 8.0, 0.0}, 6, 0.25);
    REQUIRE(flesh.all().size() == 1);
    CHECK(flesh.energy() == 11);
}

TEST_CASE("flesh loses half of its energy in a half-life and vanishes in the end", "[preserve]") {
    Food flesh(kArea);
    flesh.add(Vec3::Zero(), 1'000'000'000);
    Energy rotten = 0;
    const double share = 1.0 - std::pow(0.5, 0.1 / 60.0);
    for (int step = 0; step < 600; ++step)
        rotten += flesh.rot(share);
    CHECK(static_cast<double>(flesh.energy()) == Approx(5e8).epsilon(1e-5));
    CHECK(flesh.energy() + rotten == 1'000'000'000);
    for (int step = 0; step < 600 * 40; ++step)
        rotten += flesh.rot(share);
    CHECK(flesh.all().empty());
    CHECK(rotten == 1'000'000'000);
}

TEST_CASE("crumbs that fall close together become one piece", "[preserve]") {
    Food flesh(kArea);
    flesh.add_near(Vec3(0.0, 0.0, 0.0), 10, 0.25);
    flesh.add_near(Vec3(0.2, 0.0, 0.0), 20, 0.25);
    flesh.add_near(Vec3(0.3, 0.0, 0.0), 30, 0.25);
    REQUIRE(flesh.all().size() == 2);
    CHECK(flesh.all()[0].energy == 30);
    CHECK(flesh.all()[1].energy == 30);
    flesh.add_near(Vec3(0.0, 1.0, 0.0), 0, 0.25);
    CHECK(flesh.all().size() == 2);
}

TEST_CASE("food beyond the walls is moved between them", "[preserve]") {
    Food plants(kArea);
    plants.add(Vec3(7.0, -9.0, 0.0), 1);
    CHECK(plants.all()[0].place() == Vec3(5.0, -4.0, 0.0));
}

}  // namespace
}  // namespace cambrian
