#include "studio/panels/experiment/experiment_panel.h"

#include "panel_press.h"
#include "studio/panels/experiment/switch_group.h"

namespace cambrian {
namespace {

enum class Extent : unsigned char { kPlainOnes, kEverySetting };

struct PanelRun : test::PanelRun<ExperimentPanel> {
    explicit PanelRun(Extent extent = Extent::kEverySetting)
        : test::PanelRun<ExperimentPanel>(400.0F, 6000.0F) {
        studio.view().all_settings = extent == Extent::kEverySetting;
    }
};

TEST_CASE("the plain panel has what matters most, in plain words, and tells of other changes",
          "[studio][experiment_panel]") {
    PanelRun run(Extent::kPlainOnes);
    run.frame();
    for (const char* name : {"goal.behavior", "environment preset", "environment.gravity",
                             "environment.friction", "population.size", "mutation.rate"})
        CHECK(run.gui.has(name));
    CHECK_FALSE(run.gui.has("group goal"));
    CHECK_FALSE(run.gui.has("selection.method"));
    CHECK_FALSE(run.gui.has("1 more differs from its default"));
    ExperimentSettings edited = run.studio.editor().draft();
    edited.world.environment.gravity = 3.0;
    run.studio.editor().replace(edited);
    run.frame();
    CHECK_FALSE(run.gui.has("1 more differs from its default"));
    edited.world.trial.duration = 30.0;
    run.studio.editor().replace(edited);
    CHECK(test::asked<ChangeView>(run.click("1 more differs from its default")).view.all_settings);
    CHECK(test::asked<ChangeView>(run.click("All settings")).view.all_settings);
    run.click("environment preset");
    const auto& edit = test::asked<EditSettings>(run.click("Moon"));
    CHECK(edit.settings.world.environment.gravity == Approx(1.62));
    CHECK(edit.settings.world.trial.duration == 30.0);
}

TEST_CASE("a setting that was asked for is opened, scrolled to and lit up",
          "[studio][experiment_panel]") {
    test::PanelRun<ExperimentPanel> run(300.0F, 400.0F);
    run.studio.view().all_settings = true;
    FrameContext frame = run.studio.frame();
    const auto draw = [&] { run.gui.frame([&] { run.panel.draw(frame, run.out); }); };
    draw();
    CHECK_FALSE(run.gui.has("body.sensors.smell"));
    frame.experiment.shown = "body.sensors.smell";
    frame.experiment.show_asked = 1;
    for (int i = 0; i < 5; ++i)
        draw();
    const Rect lit = run.gui.place("## lit setting");
    CHECK(lit.y > 0);
    CHECK(lit.y + lit.height < 400);
    CHECK(run.gui.place("body.sensors.smell").y == Approx(lit.y).margin(6));
    for (int i = 0; i < 60 * 3; ++i)
        draw();
    run.gui.forget_places();
    draw();
    CHECK_FALSE(run.gui.has("## lit setting"));
}

TEST_CASE("settings of other selection methods are not shown", "[studio][experiment_panel]") {
    PanelRun run;
    run.frame();
    CHECK(run.gui.has("selection.survival"));
    CHECK_FALSE(run.gui.has("selection.map-across"));
    ExperimentSettings mapped = run.studio.editor().draft();
    mapped.selection.method = "map-elites";
    run.studio.editor().replace(mapped);
    run.gui.forget_places();
    run.frame();
    CHECK_FALSE(run.gui.has("selection.survival"));
    CHECK(run.gui.has("selection.map-across"));
}

TEST_CASE("once its groups are open, every setting that applies has a control",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.frame();
    const auto fields = setting_fields(test::kinds());
    for (const SettingField& field : fields) {
        if (field.applies && !field.applies(run.studio.editor().draft())) continue;
        const std::string control = field.table + "." + field.key;
        const std::string senses = "senses " + field.group;
        const auto shown = [&] {
            run.frame();
            return run.gui.has(control);
        };
        if (!shown() && !run.gui.has(senses)) run.click("group " + field.table);
        if (!shown() && run.gui.has(senses)) run.click(senses);
        INFO(control);
        CHECK(shown());
    }
}

TEST_CASE("a tick box switches a group of senses on, and off again once all are on",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.click("group body.sensors");
    run.frame();
    CHECK_FALSE(run.gui.has("body.sensors.smell"));
    run.click("tick Sound");
    auto edit = test::asked<EditSettings>(run.out);
    for (const char* ear : {"sound-1", "sound-2", "sound-3", "sound-4"})
        CHECK(edit.settings.founders.channels.at(ear));
    CHECK(test::was_asked<FinishEdit>(run.out));
    edit.settings.founders.channels["sound-2"] = false;
    run.studio.editor().replace(edit.settings);
    run.click("tick Sound");
    edit = test::asked<EditSettings>(run.out);
    CHECK(edit.settings.founders.channels.at("sound-2"));
    run.studio.editor().replace(edit.settings);
    run.click("tick Sound");
    CHECK_FALSE(test::asked<EditSettings>(run.out).settings.founders.channels.at("sound-1"));
    run.click("senses Smell");
    run.frame();
    CHECK(run.gui.has("body.sensors.smell"));
}

TEST_CASE("groups of senses are ticked as their switches are", "[studio][experiment_panel]") {
    const auto fields = setting_fields(test::kinds());
    ExperimentSettings settings;
    std::size_t switches = 0;
    for (const SwitchGroup& group : switch_groups(fields, "body.sensors")) {
        switches += group.switches.size();
        set_all(group, false, settings);
        CHECK(tick_of(group, settings) == Tick::kOff);
        *std::get<bool*>(group.switches[0]->at(settings)) = true;
        CHECK(tick_of(group, settings) == (group.switches.size() > 1 ? Tick::kSome : Tick::kOn));
        set_all(group, true, settings);
        CHECK(tick_of(group, settings) == Tick::kOn);
    }
    CHECK(switches == test::kinds().creature.catalog.channels.size());
    CHECK(switch_groups(fields, "environment").empty());
}

TEST_CASE("an edit asks for all settings with that field changed", "[studio][experiment_panel]") {
    PanelRun run;
    run.click("environment.ground");
    const auto& edit = test::asked<EditSettings>(run.out);
    CHECK(edit.field == "environment.ground");
    CHECK_FALSE(edit.settings.world.environment.has_ground);
    CHECK(edit.settings.population == run.studio.editor().draft().population);
    CHECK(test::was_asked<FinishEdit>(run.out));
}

TEST_CASE("choosing a goal adopts its default world", "[studio][experiment_panel]") {
    PanelRun run;
    run.click("goal.behavior");
    run.click("goal.behavior=swimming");
    const auto& edit = test::asked<EditSettings>(run.out);
    CHECK(edit.settings.goal == "swimming");
    CHECK_FALSE(edit.settings.world.environment.has_ground);
}

TEST_CASE("choosing a goal that needs a light adopts light, senses and trials",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.click("goal.behavior");
    run.click("goal.behavior=seeking");
    const auto& edit = test::asked<EditSettings>(run.out);
    CHECK(check_settings(edit.settings, test::kinds()).has_value());
    CHECK(edit.settings.world.environment.light_motion == "jumping");
    CHECK(edit.settings.founders.channels.at("light-along"));
    CHECK(edit.settings.world.trial.trials == 4);
}

TEST_CASE("choosing a goal keeps settings that were edited by hand", "[studio][experiment_panel]") {
    PanelRun run;
    ExperimentSettings own = run.studio.editor().draft();
    own.world.trial.duration = 8.0;
    run.studio.editor().replace(own);
    run.click("goal.behavior");
    run.click("goal.behavior=seeking");
    const TrialSettings& trial = test::asked<EditSettings>(run.out).settings.world.trial;
    CHECK(trial.duration == 8.0);
    CHECK(trial.trials == 4);
}

TEST_CASE("every integrator can be chosen, including the reference", "[studio][experiment_panel]") {
    for (const auto& [id, label] : test::kinds().creature.scene.integrators) {
        PanelRun run;
        if (id == run.studio.editor().draft().world.scene.integrator) continue;
        run.click("group simulation");
        run.click("simulation.integrator");
        run.click("simulation.integrator=" + id);
        CHECK(test::asked<EditSettings>(run.out).settings.world.scene.integrator == id);
    }
}

TEST_CASE("a preset changes the world and keeps the bodies' density",
          "[studio][experiment_panel]") {
    PanelRun run;
    ExperimentSettings dense = run.studio.editor().draft();
    dense.world.environment.density = 3.0;
    run.studio.editor().replace(dense);
    run.click("environment preset");
    run.click("Moon");
    const auto& edit = test::asked<EditSettings>(run.out);
    CHECK(edit.settings.world.environment.gravity == Approx(1.62));
    CHECK(edit.settings.world.environment.density == 3.0);
}

TEST_CASE("mutation presets weigh the operators on the body or the brain",
          "[studio][experiment_panel]") {
    for (const char* label : {"Tune the brain", "Reshape", "Body and brain"}) {
        PanelRun run;
        ExperimentSettings odd = run.studio.editor().draft();
        odd.mutation.weights["add-edge"] = 77.0;
        odd.mutation.rate = 2.0;
        run.studio.editor().replace(odd);
        run.click("mutation preset");
        run.click(label);
        const auto& edit = test::asked<EditSettings>(run.out);
        CHECK(test::was_asked<FinishEdit>(run.out));
        CHECK(edit.settings.mutation.rate == 2.0);
        const double body = label == std::string("Tune the brain") ? 0.2 : 1.0;
        const double brain = label == std::string("Reshape") ? 1.0 / 3.0 : 1.0;
        for (const MutationKind& kind : test::kinds().mutations.all()) {
            const double factor = kind.subject == MutationSubject::kBody ? body : brain;
            INFO(label << ": " << kind.id);
            CHECK(edit.settings.mutation.weights.at(kind.id) ==
                  Approx(factor * kind.default_weight));
        }
        CHECK(check_settings(edit.settings, test::kinds()).has_value());
    }
}

TEST_CASE("a preset lets reflexes grow and leaves the other mutations as usual",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.click("mutation preset");
    run.click("Grow reflexes");
    const auto& edit = test::asked<EditSettings>(run.out);
    for (const MutationKind& kind : test::kinds().mutations.all()) {
        INFO(kind.id);
        CHECK(edit.settings.mutation.weights.at(kind.id) ==
              (kind.id == "add-reflex" ? 25.0 : kind.default_weight));
    }
    CHECK(check_settings(edit.settings, test::kinds()).has_value());
}

TEST_CASE("the robust preset asks for the mean of three trials", "[studio][experiment_panel]") {
    PanelRun run;
    run.click("group trial");
    run.click("trial preset");
    run.click("Robust");
    const TrialSettings& trial = test::asked<EditSettings>(run.out).settings.world.trial;
    CHECK(trial.trials == 3);
    CHECK(trial.friction_jitter == 0.15);
    CHECK(trial.tilt_jitter == 2.0);
    CHECK(trial.combine == "mean");
}

TEST_CASE("a structural edit of a running experiment offers a new run",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.studio.finish_generation(1.0);
    ExperimentSettings changed = run.studio.editor().draft();
    changed.seed = 1234;
    run.studio.editor().edit(changed, "run.seed");
    run.click("Keep creatures");
    CHECK(test::asked<StartNewRun>(run.out).keep_population);
}

TEST_CASE("the other breeding shares change when one is dragged, so that the sum stays 1",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.click("group breeding");
    run.click("breeding.asexual");
    int dragged = 0;
    for (const StudioRequest& request : run.out.all()) {
        const auto* edit = test::request_if<EditSettings>(request);
        if (edit == nullptr) continue;
        const auto& shares = edit->settings.breeding.shares;
        double sum = 0.0;
        for (const auto& [way, share] : shares)
            sum += share;
        CHECK(sum == Approx(1.0));
        CHECK(shares.at("crossover") == Approx(shares.at("grafting")));
        CHECK(check_settings(edit->settings, test::kinds()).has_value());
        dragged += shares.at("asexual") != Approx(0.4) ? 1 : 0;
    }
    CHECK(dragged > 0);
}

TEST_CASE("a goal in an unsuitable world is shown with the reason", "[studio][experiment_panel]") {
    PanelRun run;
    run.frame();
    CHECK_FALSE(run.gui.has("goal mismatch"));
    ExperimentSettings dry = run.studio.editor().draft();
    dry.goal = "swimming";
    run.studio.editor().replace(dry);
    run.frame();
    CHECK(run.gui.has("goal mismatch"));
}

// Types into the control with the keyboard focus.
void type(const char* text) {
    for (; *text != '\0'; ++text)
        ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(*text));
}

TEST_CASE("the filter shows the settings found, in closed groups too",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.click("setting filter");
    type("duration");
    run.frame();
    run.gui.forget_places();
    run.frame();
    CHECK(run.gui.has("trial.duration"));
    CHECK_FALSE(run.gui.has("environment.gravity"));
    CHECK_FALSE(run.gui.has("nothing matches"));
    run.click("trial.duration");
    CHECK(test::asked<EditSettings>(run.out).field == "trial.duration");
    run.click("Clear filter");
    run.frame();
    CHECK(run.gui.has("environment.gravity"));
}

TEST_CASE("a filter that finds nothing says so, and Esc clears it", "[studio][experiment_panel]") {
    PanelRun run;
    run.gui.forget_places();
    run.click("setting filter");
    type("xylophone");
    run.frame();
    run.frame();
    CHECK(run.gui.has("nothing matches"));
    constexpr int key = 256;
    ImGui::GetIO().KeyMap[ImGuiKey_Escape] = key;
    ImGui::GetIO().KeysDown[key] = true;
    run.frame();
    ImGui::GetIO().KeysDown[key] = false;
    run.gui.forget_places();
    run.frame();
    CHECK_FALSE(run.gui.has("nothing matches"));
    CHECK(run.gui.has("environment.gravity"));
}

TEST_CASE("searching for a setting focuses the filter, and Enter focuses the value found",
          "[studio][experiment_panel]") {
    PanelRun run;
    unsigned asked = 0;
    const auto frame = [&] {
        FrameContext context = run.studio.frame();
        context.experiment.find_asked = asked;
        run.gui.frame([&] { run.panel.draw(context, run.out); });
    };
    frame();
    asked = 1;
    frame();
    frame();
    frame();
    CHECK(ImGui::GetIO().WantTextInput);
    type("gravity");
    frame();
    constexpr int key = 257;
    ImGui::GetIO().KeyMap[ImGuiKey_Enter] = key;
    ImGui::GetIO().KeysDown[key] = true;
    frame();
    ImGui::GetIO().KeysDown[key] = false;
    frame();
    frame();
    frame();
    type("1.62");
    frame();
    ImGui::GetIO().KeysDown[key] = true;
    frame();
    ImGui::GetIO().KeysDown[key] = false;
    frame();
    CHECK(test::asked<EditSettings>(run.out).settings.world.environment.gravity == Approx(1.62));
}

TEST_CASE("before the first generation no edit needs a new run", "[studio][experiment_panel]") {
    PanelRun run;
    ExperimentSettings changed = run.studio.editor().draft();
    changed.seed = 1234;
    run.studio.editor().edit(changed, "run.seed");
    run.frame();
    CHECK_FALSE(run.gui.has("New run"));
}

TEST_CASE("senses can be taken away beside them, once creatures may have them",
          "[studio][experiment_panel]") {
    PanelRun run;
    run.click("group body.sensors");
    run.frame();
    CHECK_FALSE(run.gui.has("environment.deafness"));
    CHECK_FALSE(run.gui.has("environment.anosmia"));
    ExperimentSettings hearing = run.studio.editor().draft();
    hearing.founders.channels["sound-3"] = true;
    run.studio.editor().replace(hearing);
    run.frame();
    CHECK(run.gui.place("environment.deafness").y > run.gui.place("group body.sensors").y);
    CHECK_FALSE(run.gui.has("environment.anosmia"));
    hearing.founders.channels["smell"] = true;
    run.studio.editor().replace(hearing);
    run.frame();
    CHECK(run.gui.place("environment.anosmia").y > run.gui.place("group body.sensors").y);
}

}  // namespace
}  // namespace cambrian
