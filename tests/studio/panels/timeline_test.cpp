#include "panel_press.h"
#include "studio/panels/generations/timeline_chart.h"
#include "studio/panels/generations/timeline_panel.h"
#include "support/null_imgui.h"

#include <cmath>

namespace cambrian {
namespace {

using test::click;
using test::press_key;

// Draws one frame of the panel; returns its requests.
Requests frame_of(NullImGui& gui, TimelinePanel& panel, const test::StudioFixture& studio) {
    Requests out;
    gui.frame([&] { panel.draw(studio.frame(), out); });
    return out;
}

// Displays the champion of a generation.
void show_champion(test::StudioFixture& studio, std::uint32_t generation) {
    const JudgedIndividual& champion = studio.snapshot().champions.at(generation);
    REQUIRE(studio.playback().show(exhibit_of(champion, ExhibitSource::kChampion)));
}

void finish_generations(test::StudioFixture& studio, int count) {
    for (int i = 0; i < count; ++i)
        studio.finish_generation(1.0 + std::sin(0.01 * i));
}

TEST_CASE("a drag over the timeline scrubs through the champions", "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    finish_generations(studio, 101);
    frame_of(gui, panel, studio);
    const Rect area = gui.place("timeline");
    const auto drag_to = [&](float share) {
        gui.move_to({area.x + share * area.width, area.center().y});
        return frame_of(gui, panel, studio);
    };
    drag_to(0.8F);
    gui.press();
    CHECK(test::asked<ShowChampion>(drag_to(0.8F)).generation == 80);
    CHECK(test::asked<ShowChampion>(drag_to(0.25F)).generation == 25);
    CHECK(test::asked<ShowChampion>(drag_to(-0.5F)).generation == 0);
    CHECK(test::asked<ShowChampion>(drag_to(3.0F)).generation == 100);
    show_champion(studio, 100);
    CHECK(drag_to(3.0F).all().empty());  // the creature is already displayed
    gui.release();
    drag_to(0.5F);
    CHECK(drag_to(0.5F).all().empty());
}

TEST_CASE("a click on the generation of an edited champion shows the champion again",
          "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    finish_generations(studio, 21);
    show_champion(studio, 10);
    CHECK_FALSE(test::was_asked<ShowChampion>(click(gui, panel, studio, "timeline")));
    Exhibit edited = studio.playback().exhibit();
    Genome genome = *edited.genome();
    genome.nodes[0].length = 0.6;
    Individual individual = edited.individual();
    individual.genome = std::make_shared<const Genome>(genome);
    edited.creature.individual = std::make_shared<const Individual>(individual);
    REQUIRE(studio.playback().show(edited));
    CHECK(test::asked<ShowChampion>(click(gui, panel, studio, "timeline")).generation == 10);
}

TEST_CASE("the arrow keys step through the champions and past the last to the newest",
          "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    finish_generations(studio, 30);
    CHECK(test::asked<ShowChampion>(press_key(gui, panel, studio, ImGuiKey_LeftArrow)).generation ==
          28);
    show_champion(studio, 12);
    CHECK(test::asked<ShowChampion>(press_key(gui, panel, studio, ImGuiKey_LeftArrow)).generation ==
          11);
    CHECK(
        test::asked<ShowChampion>(press_key(gui, panel, studio, ImGuiKey_RightArrow)).generation ==
        13);
    show_champion(studio, 0);
    CHECK(test::asked<ShowChampion>(press_key(gui, panel, studio, ImGuiKey_LeftArrow)).generation ==
          0);
    show_champion(studio, 29);
    CHECK(test::was_asked<ShowNewest>(press_key(gui, panel, studio, ImGuiKey_RightArrow)));
}

TEST_CASE("keys mean nothing to a timeline without the keyboard", "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    finish_generations(studio, 30);
    Requests out;
    const auto draw = [&] {
        panel.draw(studio.frame(), out);
        ImGui::SetWindowFocus(nullptr);
    };
    gui.frame(draw);
    gui.hold_key(ImGuiKey_LeftArrow, true);
    gui.frame(draw);
    gui.hold_key(ImGuiKey_LeftArrow, false);
    CHECK(out.all().empty());
}

TEST_CASE("another quantity can be chosen by mouse and by key", "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    finish_generations(studio, 3);
    click(gui, panel, studio, "timeline quantity");
    const Requests out = click(gui, panel, studio, "Diversity");
    CHECK(test::asked<ChangeView>(out).view.quantity == TimelineQuantity::kDiversity);
    const Requests up = press_key(gui, panel, studio, ImGuiKey_UpArrow);
    CHECK(test::asked<ChangeView>(up).view.quantity == TimelineQuantity::kTerrainLevel);
}

TEST_CASE("every quantity draws, in the panel and as a picture", "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    finish_generations(studio, 3);
    for (const TimelinePlot& plot : timeline_plots()) {
        INFO(plot.name);
        CHECK(&timeline_plot(plot.quantity) == &plot);
        studio.view().quantity = plot.quantity;
        gui.frame([&] {
            Requests out;
            panel.draw(studio.frame(), out);
            ImDrawList list(ImGui::GetDrawListSharedData());
            list._ResetForNewFrame();
            list.PushClipRect({0, 0}, {1280, 720});
            draw_timeline_picture(list, {0, 0, 1280, 720}, studio.snapshot(), plot.quantity,
                                  test::kinds().goals);
            CHECK(list.VtxBuffer.Size > 100);
            for (const ImDrawVert& vertex : list.VtxBuffer) {
                CHECK(vertex.pos.x >= 0.0F);
                CHECK(vertex.pos.x <= 1280.0F);
                CHECK(vertex.pos.y >= 0.0F);
                CHECK(vertex.pos.y <= 720.0F);
            }
        });
    }
}

TEST_CASE("statistics and plot are exported from a menu of the timeline", "[studio][timeline]") {
    NullImGui gui;
    TimelinePanel panel;
    test::StudioFixture studio;
    finish_generations(studio, 3);
    click(gui, panel, studio, "Export");
    const Requests table = click(gui, panel, studio, "Export statistics as CSV…");
    CHECK(test::asked<OpenFilePanel>(table).task == FileTask::kSaveStatistics);
    click(gui, panel, studio, "Export");
    const Requests picture = click(gui, panel, studio, "Export plot as PNG, 1920 × 1080…");
    CHECK(test::asked<OpenFilePanel>(picture).task == FileTask::kSavePlot);
    CHECK(test::asked<OpenFilePanel>(picture).picture.height == 1080);
}

TEST_CASE("a chart of thousands of generations costs no more than its pixels",
          "[studio][timeline]") {
    const NullImGui gui;
    EvolutionSnapshot snapshot;
    TimelineChart chart;
    const auto vertices = [&](std::uint32_t generations) {
        while (snapshot.history.size() < generations) {
            GenerationStatistics row;
            row.generation = static_cast<std::uint32_t>(snapshot.history.size());
            row.best = std::sin(row.generation);
            row.lower = row.best - 1.0;
            snapshot.history.push_back(row);
        }
        chart.gather(snapshot, TimelineQuantity::kFitness);
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        chart.draw(list, chart.scale_for({0, 0, 500, 100}));
        return list.VtxBuffer.Size;
    };
    const int of_thousands = vertices(5'000);
    CHECK(vertices(50'000) < of_thousands * 11 / 10);
}

TEST_CASE("births by line are bands of all births, one on the other", "[studio][timeline]") {
    const NullImGui gui;
    EvolutionSnapshot snapshot;
    TimelineChart chart;
    const auto vertices = [&](std::vector<LineBirths> births) {
        GenerationStatistics row;
        row.generation = static_cast<std::uint32_t>(snapshot.history.size());
        row.births = std::move(births);
        snapshot.history.push_back(row);
        chart.gather(snapshot, TimelineQuantity::kLines);
        const PlotScale scale = chart.scale_for({0, 0, 500, 100});
        CHECK(scale.y_high >= 20.0);
        CHECK(scale.y_high < 30.0);
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        chart.draw(list, scale);
        return list.VtxBuffer.Size;
    };
    vertices({{1, 12}, {2, 8}});
    CHECK(vertices({{2, 19}, {1, 1}}) > 0);
}

TEST_CASE("the row under the mouse is the nearest generation's", "[studio][timeline]") {
    EvolutionSnapshot snapshot;
    for (std::uint32_t generation = 7; generation <= 27; ++generation) {
        snapshot.history.emplace_back();
        snapshot.history.back().generation = generation;
    }
    TimelineChart chart;
    chart.gather(snapshot, TimelineQuantity::kParts);
    const PlotScale scale = chart.scale_for({100, 0, 200, 100});
    CHECK(chart.row_at(scale, 0) == 0);
    CHECK(chart.row_at(scale, 104) == 0);
    CHECK(chart.row_at(scale, 106) == 1);
    CHECK(chart.row_at(scale, 200) == 10);
    CHECK(chart.row_at(scale, 900) == 20);
}

TEST_CASE("another goal starts a new piece of the curve on a scale of its own",
          "[studio][timeline]") {
    NullImGui gui;
    test::StudioFixture studio;
    const auto judge_by = [&](const char* goal) {
        ExperimentSettings settings = *studio.snapshot().settings;
        settings.goal = goal;
        studio.snapshot().settings = std::make_shared<const ExperimentSettings>(settings);
    };
    judge_by("walking");
    for (const double best : {10.0, 20.0, 30.0})
        studio.finish_generation(best);
    judge_by("seeking");
    studio.finish_generation(0.25);
    studio.finish_generation(0.5);
    judge_by("jumping");  // no generation has been judged by it yet
    CHECK(goal_in(studio.snapshot(), 2) == "walking");
    CHECK(goal_in(studio.snapshot(), 4) == "seeking");
    TimelineChart chart;
    chart.gather(studio.snapshot(), TimelineQuantity::kFitness);
    CHECK(chart.piece_count() == 2);
    const PlotScale whole = chart.scale_for({0, 0, 100, 100});
    CHECK(whole.y_high < 1.0);
    CHECK(chart.scale_at(whole, 2).y_high > 30.0);
    CHECK(chart.scale_at(whole, 3).y_high == whole.y_high);
    CHECK(chart.scale_at(whole, 2).x_at(2.0) == whole.x_at(2.0));
    chart.gather(studio.snapshot(), TimelineQuantity::kParts);
    CHECK(chart.piece_count() == 1);
}

}  // namespace
}  // namespace cambrian
