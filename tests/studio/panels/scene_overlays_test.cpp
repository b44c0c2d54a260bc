#include "studio/panels/viewport/scene_overlays.h"

#include "studio/look/overlays.h"
#include "studio/panels/viewport/viewport_panel.h"
#include "studio_fixture.h"
#include "support/null_imgui.h"

namespace cambrian {
namespace {

class OverlayRun {
public:
    OverlayRun() {
        studio.show_crawler();
        run();
    }
    void run() {
        for (int i = 0; i < 150; ++i)
            studio.playback().step();
    }
    template <class Add>
    SceneFrame drawn(Add add) {
        const Playback& playback = studio.playback();
        const CreatureLook look{
            playback.creature().phenotype(), playback.creature().motion().poses(), {}, 0.3, {}};
        const Palette palette = palette_of(ThemeKind::kDark);
        SceneFrame frame;
        add(frame,
            OverlayScene{look, playback.trial().scene(), playback.trial().creature(),
                         playback.trial().surroundings(), test::kinds().creature, palette, 0.01});
        return frame;
    }
    test::StudioFixture studio;
};

TEST_CASE("each overlay switches something of the picture on and off", "[studio][overlays]") {
    OverlayRun run;
    run.studio.show_calling_crawler();
    run.run();
    for (const OverlayKind& overlay : overlay_kinds()) {
        // Names are not shapes, and the crawler reads no sensor.
        if (overlay.shown == &OverlaysShown::names || overlay.shown == &OverlaysShown::sensors)
            continue;
        std::size_t shapes[2] = {0, 0};
        for (const bool shown : {false, true}) {
            NullImGui gui;
            ViewportPanel panel(nullptr);
            OverlaysShown& overlays = run.studio.view().overlays;
            for (const OverlayKind& each : overlay_kinds())
                overlays.*each.shown = false;
            overlays.*overlay.shown = shown;
            // Other looks show less of a skin where an overlay would be hidden by it.
            run.studio.view().look =
                overlay.shown == &OverlaysShown::ruler ? LookMode::kLife : LookMode::kMechanics;
            const FrameContext frame = run.studio.frame();
            Requests out;
            gui.frame([&] { panel.draw(frame, out); });
            shapes[shown ? 1 : 0] = panel.scene().shapes.size();
        }
        INFO(overlay.label);
        CHECK(shapes[1] > shapes[0]);
    }
}

TEST_CASE("plain scenery is none, light scenery is less than the full one", "[studio][overlays]") {
    OverlayRun run;
    std::vector<std::size_t> shapes;
    for (const Scenery scenery : {Scenery::kPlain, Scenery::kLight, Scenery::kFull}) {
        NullImGui gui;
        ViewportPanel panel(nullptr);
        run.studio.view().overlays.grid = false;
        FrameContext frame = run.studio.frame();
        frame.window.scenery = scenery;
        Requests out;
        gui.frame([&] { panel.draw(frame, out); });
        CHECK((panel.scene().backdrop == nullptr) == (scenery == Scenery::kPlain));
        shapes.push_back(panel.scene().shapes.size());
    }
    CHECK(shapes[0] < shapes[1]);
    CHECK(shapes[1] < shapes[2]);
}

TEST_CASE("the needle of a joint is between its limits", "[studio][overlays]") {
    OverlayRun run;
    const SceneFrame frame = run.drawn(add_joint_limits);
    CHECK(frame.shapes.size() >= 4 * run.studio.playback().creature().phenotype().effectors.size());
}

TEST_CASE("the readings of sensors are drawn at their parts", "[studio][overlays]") {
    OverlayRun run;
    const Playback& playback = run.studio.playback();
    const SensorRegistry& kinds = test::kinds().creature.sensors;
    const auto kind = [&kinds](const char* id) {
        return static_cast<std::uint8_t>(kinds.index_of(id).value());
    };
    Phenotype sensing = playback.creature().phenotype();
    sensing.sensors = {
        {.part = 1, .kind = kind("joint")},
        {.part = 0, .kind = kind("contact"), .channel = 1, .mirror = {.across = -1}}};
    const CreatureLook look{sensing, playback.creature().motion().poses(), {}, 0.3, {}};
    const Palette palette = palette_of(ThemeKind::kDark);
    SceneFrame frame;
    const Creature creature(sensing, test::kinds().creature, playback.trial().world().scene);
    add_sensor_readings(frame,
                        {look, playback.trial().scene(), creature, playback.trial().surroundings(),
                         test::kinds().creature, palette, 0.01});
    // On a mirrored part, the left face is on the right, at the lower side of the box.
    const Vec3& half = sensing.plan.parts[0].half_extents;
    const Vec3 at = transform(playback.creature().motion().poses()[0], {0.0, -0.8 * half.y(), 0.0});
    CHECK((frame.shapes.back().center - at.head<2>()).norm() < 1e-9);
    CHECK(frame.shapes.size() > 3);
}

TEST_CASE("every contact force is drawn as a line with a dot", "[studio][overlays]") {
    OverlayRun run;
    std::vector<SceneContact> contacts;
    run.studio.playback().trial().scene().list_contacts(contacts);
    const SceneFrame frame = run.drawn(add_contact_forces);
    CHECK(frame.shapes.size() == 2 * contacts.size());
}

}  // namespace
}  // namespace cambrian
