#include "studio/playback/energy_trace.h"

#include "studio_fixture.h"

namespace cambrian {
namespace {

TEST_CASE("the muscles' work is the sum of all other energies", "[studio][energy_trace]") {
    SceneAudit audit;
    audit.motor_work = 10.0;
    audit.drag_work = -3.0;
    audit.contact_work = -2.0;
    audit.limit_work = -0.5;
    audit.impulse_work = -1.5;
    audit.energy_residual = -0.25;
    const EnergySample sample = energy_sample(2.0, audit);
    CHECK(sample.drag == 3.0);
    CHECK(sample.contacts == 4.0);
    CHECK(sample.unexplained == 0.25);
    CHECK(sample.drag + sample.contacts + sample.stored + sample.unexplained ==
          Approx(sample.muscles));
}

TEST_CASE("readings are a tenth of a second apart and follow a step back in time",
          "[studio][energy_trace]") {
    EnergyTrace trace;
    for (int tick = 0; tick <= 60; ++tick)
        trace.add(tick / 60.0, {});
    CHECK(trace.samples().size() == 11);
    trace.add(0.45, {});
    CHECK(trace.samples().size() == 5);
    CHECK(trace.samples().back().time == Approx(0.4));
}

TEST_CASE("the stored energy is the change of the scene's energy", "[studio][energy_trace]") {
    test::StudioFixture studio;
    studio.show_crawler();
    Playback& playback = studio.playback();
    while (playback.trial().settling() || playback.creature().readings().energy().samples().empty())
        playback.step();
    const double before = playback.trial().scene().energy();
    const EnergySample first = playback.creature().readings().energy().samples().back();
    const std::size_t size = playback.creature().readings().energy().samples().size();
    while (playback.creature().readings().energy().samples().size() < size + 10)
        playback.step();
    const EnergySample& last = playback.creature().readings().energy().samples().back();
    CHECK(last.muscles != 0.0);
    CHECK(last.stored - first.stored ==
          Approx(playback.trial().scene().energy() - before).margin(1e-6));
    playback.restart();
    CHECK(playback.creature().readings().energy().samples().empty());
}

}  // namespace
}  // namespace cambrian
