// The loudness of many sounds, and the noise of impacts.
#include "core/random.h"
#include "simulator/surroundings/impact_noise.h"
#include "simulator/surroundings/loudness_sum.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

constexpr std::uint32_t kListener = 1000;

struct Call {
    Sound sound;
    std::uint32_t creature = 0;
};

LoudnessSum summed(const std::vector<Call>& calls) {
    LoudnessSum sum;
    sum.reserve(calls.size());
    for (const Call& call : calls)
        sum.add(call.sound, call.creature);
    sum.finish();
    return sum;
}

std::vector<Call> random_calls(int count, double span, std::uint64_t seed) {
    RandomStream stream(seed);
    std::vector<Call> calls;
    for (int i = 0; i < count; ++i) {
        const Vec3 place(stream.uniform(-span, span), stream.uniform(-span, span), 0.0);
        calls.push_back({{place, stream.between(0, 3), stream.uniform(0.05, 1.0)},
                         static_cast<std::uint32_t>(stream.below(60))});
    }
    return calls;
}

double exact_at(const std::vector<Call>& calls, const Vec3& point, int band, std::uint32_t creature,
                double from = 0.0) {
    double sum = 0.0;
    for (const Call& call : calls) {
        const double distance = (call.sound.place - point).norm();
        if (call.sound.band == band && call.creature != creature && distance >= from)
            sum += loudness_at(distance, call.sound.loudness);
    }
    return sum;
}

}  // namespace

TEST_CASE("loudness falls with one metre and the distance", "[simulator][sound]") {
    struct Row {
        double distance, heard;
    };
    const LoudnessSum sum = summed({{{Vec3(2.0, 1.0, 0.0), 1, 0.8}, 5}});
    for (const Row& row : {Row{0.0, 0.8}, Row{1.0, 0.4}, Row{3.0, 0.2}, Row{10.0, 0.8 / 11.0}}) {
        const Vec3 point(2.0, 1.0 - row.distance, 0.0);
        CHECK(sum.at(point, 1, kListener) == Approx(row.heard).epsilon(1e-12));
        CHECK(sum.at(point, 0, kListener) == 0.0);
        CHECK(sum.at(point, 1, 5) == 0.0);
    }
}

TEST_CASE("the sum over cells is within 3 per cent of the exact one", "[simulator][sound]") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        std::vector<Call> calls = random_calls(300, 20.0, seed);
        RandomStream stream(seed + 100);
        for (int i = 0; i < 50; ++i) {
            const Vec3 point(stream.uniform(-20.0, 20.0), stream.uniform(-20.0, 20.0), 0.0);
            std::vector<Call> far;
            for (const Call& call : calls) {
                if ((call.sound.place - point).norm() >= 6.0) far.push_back(call);
            }
            const auto creature = static_cast<std::uint32_t>(stream.below(60));
            const LoudnessSum sum = summed(far);
            for (int band = 0; band < kSoundBands; ++band) {
                REQUIRE(sum.at(point, band, creature) ==
                        Approx(exact_at(far, point, band, creature)).epsilon(0.03));
            }
        }
    }
}

TEST_CASE("sounds nearby are summed exactly", "[simulator][sound]") {
    const std::vector<Call> calls = random_calls(40, 3.9, 7);
    const LoudnessSum sum = summed(calls);
    for (int band = 0; band < kSoundBands; ++band)
        CHECK(sum.at({0.3, -0.2, 0.0}, band, 3) ==
              Approx(exact_at(calls, {0.3, -0.2, 0.0}, band, 3)).epsilon(1e-13));
}

TEST_CASE("the order in which creatures are added changes no bit", "[simulator][sound]") {
    std::vector<Call> calls = random_calls(200, 15.0, 9);
    const auto by_creature = [](const Call& a, const Call& b) { return a.creature < b.creature; };
    std::stable_sort(calls.begin(), calls.end(), by_creature);
    const LoudnessSum forwards = summed(calls);
    std::stable_sort(calls.begin(), calls.end(),
                     [&](const Call& a, const Call& b) { return by_creature(b, a); });
    const LoudnessSum backwards = summed(calls);
    RandomStream stream(10);
    for (int i = 0; i < 100; ++i) {
        const Vec3 point(stream.uniform(-15.0, 15.0), stream.uniform(-15.0, 15.0), 0.0);
        const int band = stream.between(0, 3);
        REQUIRE(forwards.at(point, band, 4) == backwards.at(point, band, 4));
    }
}

TEST_CASE("faint sounds are left out, and far away nothing overflows", "[simulator][sound]") {
    const LoudnessSum sum =
        summed({{{Vec3::Zero(), 0, 0.01}, 1}, {{Vec3(1e300, 0, 0), 0, 1.0}, 2}});
    CHECK(sum.at(Vec3::Zero(), 0, kListener) == Approx(0.0).margin(1e-200));
}

TEST_CASE("impacts are heard by their impulse", "[simulator][sound]") {
    const Vec3 place(1.0, 2.0, 0.0);
    std::vector<Sound> sounds;
    const std::vector<SceneImpact> impacts = {
        {place, 0, -1, 0.02}, {place, 0, -1, 0.1}, {place, 1, 2, 3.0}};
    add_noise(impacts, sounds);
    REQUIRE(sounds.size() == 2);
    CHECK(sounds[0].band == kGroundBand);
    CHECK(sounds[0].loudness == Approx(0.2));
    CHECK(sounds[0].place == place);
    CHECK(sounds[1].band == kCreatureBand);
    CHECK(sounds[1].loudness == 1.0);
}

TEST_CASE("where edges meet, sounds come from their nearest images", "[simulator][sound]") {
    RandomStream stream(11);
    for (const Torus torus : {Torus{9.0, 7.0}, Torus{60.0, 42.0}}) {
        LoudnessSum sum(torus);
        std::vector<Call> calls = random_calls(60, 40.0, 5);
        for (Call& call : calls) {
            call.sound.place = torus.shortest(call.sound.place);
            sum.add(call.sound, call.creature);
        }
        sum.finish();
        for (int i = 0; i < 100; ++i) {
            const Vec3 point =
                torus.shortest({stream.uniform(-40.0, 40.0), stream.uniform(-40.0, 40.0), 0.0});
            double expected = 0.0;
            for (const Call& call : calls) {
                if (call.sound.band != 1) continue;
                const double distance = torus.shortest(call.sound.place - point).norm();
                expected += loudness_at(distance, call.sound.loudness);
            }
            CHECK(sum.at(point, 1, kListener) == Approx(expected).epsilon(0.05));
        }
    }
}
