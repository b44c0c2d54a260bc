#include "sensors/sensor.h"

#include "creature/fake_scene.h"
#include "support/catch.h"

using namespace cambrian;

namespace {

double read(const FakeScene& scene, std::size_t kind, std::size_t channel, int handedness) {
    static const SensorRegistry sensors = builtin_sensors();
    return sensors[kind].read(scene, 0, channel, handedness);
}

}  // namespace

TEST_CASE("channels have the absolute numbers genes rely on", "[sensors]") {
    std::vector<std::string> channels;
    const SensorRegistry sensors = builtin_sensors();
    for (const SensorKind& sensor : sensors.all()) {
        for (const SensorChannel& channel : sensor.channels)
            channels.push_back(channel.id);
    }
    CHECK(channels == std::vector<std::string>{"joint", "contact-distal", "contact-left",
                                               "contact-proximal", "contact-right"});
}

TEST_CASE("the joint sensor reads the coordinate, turned round on mirrored parts", "[sensors]") {
    FakeScene scene(1);
    scene.coordinates[0] = 0.7;
    CHECK(read(scene, 0, 0, 1) == 0.7);
    CHECK(read(scene, 0, 0, -1) == -0.7);
}

TEST_CASE("each contact channel reads its own face, sides exchanged on mirrored parts",
          "[sensors]") {
    constexpr std::array<std::size_t, 4> mirrored = {0, 3, 2, 1};
    for (std::size_t face = 0; face < kFaceCount; ++face) {
        FakeScene scene(1);
        scene.touched[0][face] = true;
        for (std::size_t channel = 0; channel < kFaceCount; ++channel) {
            CHECK(read(scene, 1, channel, 1) == (channel == face ? 1.0 : -1.0));
            CHECK(read(scene, 1, channel, -1) == (mirrored[channel] == face ? 1.0 : -1.0));
        }
    }
}
