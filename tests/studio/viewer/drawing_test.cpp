// Drawing a creature, from the first part to a run that begins with it.

#include "core/random.h"
#include "persist/creature/creature_file.h"
#include "sketch/part_edits.h"
#include "sketch/rhythm.h"
#include "studio_fixture.h"
#include "studio_run.h"

namespace cambrian {
namespace {

using test::StudioRun;

ViewerView viewer(const StudioRun& run) {
    return run.studio.frame_context().viewer;
}

SketchRules rules_in(const StudioRun& run) {
    const ExperimentSettings& settings = test::shown_in(run).settings();
    return {test::creature_kinds(), settings.expression, settings.world.scene};
}

BodySketch sketched(const StudioRun& run) {
    return sketch_of(*test::shown_in(run).genome(), rules_in(run));
}

void draw(StudioRun& run, Genome genome, const std::string& place) {
    run.ask(EditGenes{std::make_shared<const Genome>(std::move(genome)), {place, "", "drawn"}});
    run.ask(FinishGeneEdit{});
}

// Draws a part and chooses it.
void draw_part(StudioRun& run, const Vec2& from, const Vec2& to) {
    auto grown = grow_part(sketched(run), 0, {from, to}, rules_in(run));
    REQUIRE(grown);
    draw(run, grown->genome, "part 1");
    run.ask(ChoosePart{grown->name});
}

std::string text_of(const Exhibit& exhibit) {
    return write_creature(creature_document(exhibit.creature, test::kinds()), test::kinds());
}

TEST_CASE("a new creature is one part on paper, and rests", "[studio][drawing]") {
    StudioRun run;
    run.studio.show_founders();
    CHECK(run.studio.frame_context().may_draw_creature());
    run.ask(DrawNewCreature{});
    CHECK(run.studio.frame_context().drawing());
    CHECK_FALSE(run.studio.frame_context().founders_shown());
    CHECK(sketched(run).body.parts.size() == 1);
    CHECK_FALSE(viewer(run).playback.pace().playing);
    CHECK(test::shown_in(run).individual().method == "drawn");
    run.ask(ToggleDrawing{});
    CHECK_FALSE(run.studio.frame_context().drawing());
    CHECK(viewer(run).playback.pace().playing);
}

TEST_CASE("the chosen part is repeated, mirrored and removed, each as one step",
          "[studio][drawing]") {
    StudioRun run;
    run.studio.show_founders();
    run.ask(DrawNewCreature{});
    draw_part(run, {0.25, -0.11}, {0.3, -0.5});
    const auto parts = [&] { return sketched(run).body.parts.size(); };
    run.ask(RepeatPart{3});
    CHECK(parts() == 4);
    run.ask(SwitchPair{});
    CHECK(parts() == 7);
    run.ask(RemovePart{});
    CHECK(parts() == 1);
    const std::array<std::size_t, 4> before = {7, 4, 2, 1};
    for (const std::size_t count : before) {
        run.ask(UndoEdit{});
        CHECK(parts() == count);
    }
    CHECK_FALSE(viewer(run).genes->can_undo());
    run.ask(RedoEdit{});
    CHECK(parts() == 2);
}

TEST_CASE("what cannot be done with a part is said", "[studio][drawing]") {
    StudioRun run;
    run.studio.show_founders();
    run.ask(DrawNewCreature{});
    const GenomePtr box = test::shown_in(run).genome();
    const auto told = [&](const std::string& words) {
        run.studio.update(1.0, 0.001);
        const Notice* notice = run.studio.frame_context().window.notice;
        return notice != nullptr && notice->text.find(words) != std::string::npos;
    };
    run.ask(RemovePart{});
    CHECK(told("Click a part first."));
    run.ask(ChoosePart{name_of(sketched(run), 0)});
    run.ask(SwitchPair{});
    CHECK(told("This is the first part"));
    run.ask(GiveRhythm{});
    CHECK(told("A rhythm needs a joint"));
    CHECK(test::shown_in(run).genome() == box);
}

TEST_CASE("the drag of a rhythm's slider is one step", "[studio][drawing]") {
    StudioRun run;
    run.studio.show_founders();
    run.ask(DrawNewCreature{});
    draw_part(run, {0.25, -0.11}, {0.3, -0.5});
    const auto rhythm = [&] { return rhythm_of(sketched(run), rules_in(run)); };
    run.ask(GiveRhythm{});
    run.ask(FinishGeneEdit{});
    for (const double frequency : {1.1, 1.2, 1.3})
        run.ask(GiveRhythm{{frequency, 0.4, 1.0}});
    run.ask(FinishGeneEdit{});
    REQUIRE(rhythm());
    CHECK(rhythm()->frequency == 1.3);
    run.ask(UndoEdit{});
    REQUIRE(rhythm());
    CHECK(rhythm()->frequency == Rhythm{}.frequency);
    run.ask(UndoEdit{});
    CHECK_FALSE(rhythm());
}

TEST_CASE("no champion takes the paper away", "[studio][drawing]") {
    StudioRun run;
    run.studio.show_founders();
    run.ask(DrawNewCreature{});
    draw_part(run, {0.25, -0.11}, {0.3, -0.5});
    const GenomePtr drawn = test::shown_in(run).genome();
    run.ask(RunOneGeneration{});
    REQUIRE(run.frames_until([&] { return run.champions() == 1; }));
    CHECK(test::shown_in(run).genome() == drawn);
    CHECK(run.studio.frame_context().drawing());
}

TEST_CASE("a drawn creature founds a run", "[studio][drawing]") {
    StudioRun run;
    run.studio.show_founders();
    run.ask(DrawNewCreature{});
    draw_part(run, {0.25, -0.11}, {0.3, -0.5});
    run.ask(GiveRhythm{});
    const GenomePtr drawn = test::shown_in(run).genome();
    run.ask(EvolveShown{false});
    CHECK_FALSE(viewer(run).drawing.on);
    REQUIRE(run.frames_until([&] { return run.champions() >= 1; }));
    const auto snapshot = run.studio.frame_context().experiment.snapshot;
    CHECK(!snapshot.history.empty());
    run.ask(ToggleEvolution{});
    bool found = false;
    for (const JudgedIndividual& champion : snapshot.champions)
        found = found || champion.genome() == *drawn;
    for (const IndividualPtr& individual : snapshot.population)
        found = found || *individual->genome == *drawn || individual->parents[0] != 0;
    CHECK(found);
}

// One stroke of a hand that draws anything anywhere.
Genome any_stroke(const BodySketch& sketch, const SketchRules& rules, RandomStream& stream) {
    const auto point = [&] { return Vec2(stream.uniform(-2.0, 2.0), stream.uniform(-2.0, 2.0)); };
    const std::size_t part = stream.below(sketch.body.parts.size());
    const std::size_t kind = stream.below(6);
    if (kind < 3) {
        const NewPart drawn{point(), point(), static_cast<MirrorSides>(stream.below(3))};
        auto grown = grow_part(sketch, part, drawn, rules);
        if (grown) return std::move(grown->genome);
    }
    if (kind == 3) return drag_side(sketch, part, point());
    if (kind == 4 && part > 0) return slide_joint(sketch, part, point());
    if (kind == 5 && part > 0 && stream.chance(0.4)) return remove_part(sketch, part, rules);
    return drag_end(sketch, part, point());
}

TEST_CASE("200 strokes are all taken back to the same bytes", "[studio][drawing]") {
    StudioRun run;
    run.studio.show_founders();
    run.ask(ToggleDrawing{});
    const std::string before = text_of(test::shown_in(run));
    const GenomePtr original = test::shown_in(run).genome();
    RandomStream stream(5);
    for (int i = 0; i < 200; ++i) {
        const GenomePtr last = test::shown_in(run).genome();
        draw(run, any_stroke(sketched(run), rules_in(run), stream), std::to_string(i));
        REQUIRE(test::shown_in(run).genome() != last);
    }
    int undone = 0;
    while (viewer(run).genes->can_undo()) {
        run.ask(UndoEdit{});
        ++undone;
    }
    CHECK(undone == 200);
    CHECK(test::shown_in(run).genome() == original);
    CHECK(text_of(test::shown_in(run)) == before);
}

}  // namespace
}  // namespace cambrian
