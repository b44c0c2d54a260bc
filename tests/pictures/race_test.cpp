#include "pictures/race.h"

#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

Subject runner(const std::string& name) {
    const auto file = std::string(CAMBRIAN_SOURCE_DIR "/assets/creatures/") + name;
    const auto document = load_creature(file + ".creature.json", test::kinds());
    REQUIRE(document);
    auto subject = subject_of(*document, document->settings(), name, test::kinds());
    REQUIRE(subject);
    return *std::move(subject);
}

Vec3 travelled(const Subject& subject) {
    const std::vector<MotionFrame>& frames = subject.motion().frames;
    return frames.back().center_of_mass - frames.front().center_of_mass;
}

TEST_CASE("all runners of a race run to the right, as far as in their trials", "[pictures][race]") {
    std::vector<Subject> walkers;
    for (const char* name : {"biped", "crawler", "pacer", "walker", "worm", "trotter"})
        walkers.push_back(runner(name));
    CHECK(std::any_of(walkers.begin(), walkers.end(),
                      [](const Subject& each) { return travelled(each).x() < -0.1; }));
    const Race race(walkers);
    CHECK(race.length() == Approx(15.0));
    for (std::size_t i = 0; i < walkers.size(); ++i) {
        CHECK(race.distance(i, 0.0) == 0.0);
        CHECK(race.distance(i, 99.0) == Approx(std::abs(travelled(walkers[i]).x())));
    }
}

TEST_CASE("a swimmer is turned about its start, however it lay", "[pictures][race]") {
    std::vector<Subject> swimmers;
    for (const char* name : {"dart", "medusa", "scissors"})
        swimmers.push_back(runner(name));
    const Race race(swimmers);
    for (std::size_t i = 0; i < swimmers.size(); ++i)
        CHECK(race.distance(i, 99.0) == Approx(travelled(swimmers[i]).norm()));
}

}  // namespace
}  // namespace cambrian
