#include "panel_press.h"
#include "studio/panels/inspector/ancestry_tab.h"
#include "studio/panels/inspector/brain_tab.h"
#include "studio/panels/inspector/energy_tab.h"
#include "studio/panels/inspector/gene_table.h"
#include "studio/panels/inspector/genotype_tab.h"
#include "studio/panels/inspector/inspector_panel.h"
#include "studio/viewer/mutation_words.h"
#include "studio_fixture.h"
#include "support/null_imgui.h"

#include <algorithm>

namespace cambrian {
namespace {

// A tab of the inspector for the crawler, and its requests.
template <class Tab>
class TabRun {
public:
    TabRun() { studio.show_crawler(); }

    Requests click(const std::string& name) {
        Requests out;
        gui.click(name, [&] { tab.draw(studio.frame(), out); });
        return out;
    }
    Requests point_at(const std::string& name) {
        Requests out;
        const auto draw = [&] { tab.draw(studio.frame(), out); };
        gui.frame(draw);
        gui.move_to(gui.place(name).center());
        gui.frame(draw);
        out.take();
        gui.frame(draw);
        return out;
    }

    NullImGui gui;
    Tab tab;
    test::StudioFixture studio;
};

TEST_CASE("every tab of the inspector draws", "[studio][inspector]") {
    NullImGui gui;
    InspectorPanel panel;
    test::StudioFixture studio;
    studio.show_crawler();
    for (int i = 0; i < 100; ++i)
        studio.playback().step();
    Requests out;
    for (const char* tab : {"Brain", "Genotype", "Ancestry", "Energy", "Lesions", "Creature"})
        gui.click(tab, [&] { panel.draw(studio.frame(), out); });
    CHECK(gui.has("brain node 0"));
    CHECK(gui.has("gene 0"));
    CHECK(gui.has("ancestor 0"));
    CHECK(gui.has("energy"));
}

TEST_CASE("pointing at a neuron highlights its part", "[studio][inspector]") {
    TabRun<BrainTab> run;
    const Requests out = run.point_at("brain node 0");
    CHECK(test::asked<ShowHighlight>(out).highlight.part == 1);
}

TEST_CASE("the chosen neuron is forced and released by its switch", "[studio][inspector]") {
    TabRun<BrainTab> run;
    run.click("brain node 0");
    const ForceNeuron force = test::asked<ForceNeuron>(run.click("force neuron"));
    run.studio.playback().creature().force(force.neuron, force.value);
    CHECK(test::asked<ReleaseNeuron>(run.click("force neuron")).neuron == force.neuron);
}

TEST_CASE("moving the slider forces the chosen neuron", "[studio][inspector]") {
    TabRun<BrainTab> run;
    for (int i = 0; i < 60; ++i)
        run.studio.playback().step();
    run.click("brain node 0");
    CHECK(test::asked<ForceNeuron>(run.click("forced value")).value == Approx(0.0).margin(0.05));
}

TEST_CASE("a chosen gene keeps its parts highlighted until it is chosen again",
          "[studio][inspector]") {
    TabRun<GenotypeTab> run;
    run.click("gene 2");
    run.gui.move_to({-1, -1});
    Requests out;
    run.gui.frame([&] { run.tab.draw(run.studio.frame(), out); });
    CHECK(test::asked<ShowHighlight>(out).highlight.chosen == 2);
    run.click("gene 2");
    run.gui.move_to({-1, -1});
    out.take();
    run.gui.frame([&] { run.tab.draw(run.studio.frame(), out); });
    CHECK_FALSE(test::was_asked<ShowHighlight>(out));
}

TEST_CASE("the genotype ignores a highlighted part that the creature lacks",
          "[studio][inspector]") {
    TabRun<GenotypeTab> run;
    Requests out;
    run.gui.frame([&] {
        FrameContext frame = run.studio.frame();
        frame.viewer.highlight.part = 100'000;
        run.tab.draw(frame, out);
    });
    CHECK(run.gui.has("gene 0"));
}

TEST_CASE("a gene's switch asks for the genome with that gene changed", "[studio][inspector]") {
    TabRun<GenotypeTab> run;
    const Requests out = run.click("part 0 symmetric");
    const EditGenes& edit = test::asked<EditGenes>(out);
    CHECK(edit.change.place == "part 0 symmetric");
    CHECK(edit.change.from == "no");
    CHECK(edit.change.to == "yes");
    CHECK(edit.genome->nodes[0].symmetric);
    CHECK(test::was_asked<FinishGeneEdit>(out));
    Genome restored = *edit.genome;
    restored.nodes[0].symmetric = false;
    CHECK(restored == *run.studio.playback().exhibit().genome());
}

TEST_CASE("a gene's slider changes its number within its range", "[studio][inspector]") {
    TabRun<GenotypeTab> run;
    const Requests out = run.click("part 0 length");
    CHECK(test::asked<EditGenes>(out).genome->nodes[0].length == Approx(0.84).margin(0.05));
    CHECK(test::was_asked<FinishGeneEdit>(out));
}

TEST_CASE("no new champion replaces the creature from the moment a gene is grasped",
          "[studio][inspector]") {
    TabRun<GenotypeTab> run;
    const auto draw = [&](Requests& out) {
        run.gui.frame([&] { run.tab.draw(run.studio.frame(), out); });
    };
    Requests out;
    draw(out);
    run.gui.move_to(run.gui.place("part 0 length").center());
    draw(out);
    CHECK_FALSE(test::was_asked<ChangeView>(out));
    run.gui.press();
    draw(out);
    CHECK_FALSE(test::asked<ChangeView>(out).view.newest_champion);
}

TEST_CASE("a neuron of another function gets as many inputs as it needs", "[studio][inspector]") {
    TabRun<GenotypeTab> run;
    run.click("gene 1");
    const KindCatalog& catalog = test::kinds().creature.catalog;
    const auto sum = std::find_if(catalog.functions.begin(), catalog.functions.end(),
                                  [](const FunctionEntry& each) { return each.arity == 3; });
    REQUIRE(sum != catalog.functions.end());
    run.click("part 1 neuron 0 function");
    const EditGenes edit =
        test::asked<EditGenes>(run.click("part 1 neuron 0 function=" + sum->label));
    CHECK(edit.genome->nodes[1].neurons[0].inputs.size() == 3);
    CHECK(validate(*edit.genome, catalog).empty());
}

TEST_CASE("genes of space have rows, and a joint as many degrees as it needs",
          "[studio][inspector]") {
    const Kinds& kinds = test::spatial_kinds().creature;
    Genome genome = lifted(*test::crawler_exhibit().genome(), 0.0);
    repair(genome, kinds.catalog);
    EdgeGene& edge = genome.nodes[0].edges[0];
    for (double* number :
         {&genome.root_tilt, &genome.root_roll, &edge.height, &edge.tilt, &edge.roll})
        *number = 0.3;  // not where a click in the middle of a slider puts it
    NullImGui gui;
    const auto click = [&](std::size_t node, const std::string& name) {
        GeneEdit made;
        gui.click(name, [&] {
            const GeneEdit edit = gene_table(genome, node, kinds);
            if (edit.change) made = edit;
        });
        REQUIRE(made.change);
        CHECK(validate(genome, kinds.catalog).empty());
        return made.change->place;
    };
    for (const char* place :
         {"root tilt", "root roll", "part 0 depth", "part 0 edge 0 height", "part 0 edge 0 tilt",
          "part 0 edge 0 roll", "part 0 edge 0 reflect depth"})
        CHECK(click(0, place) == place);
    CHECK(edge.reflect_depth);
    gui.click("part 1 joint", [&] { gene_table(genome, 1, kinds); });
    CHECK(click(1, "part 1 joint=Universal") == "part 1 joint");
    REQUIRE(genome.nodes[1].further.size() == 1);
    for (const char* place :
         {"part 1 degree 2 low limit", "part 1 degree 2 high limit", "part 1 effector 2"})
        CHECK(click(1, place) == place);
    CHECK(genome.nodes[1].further[0].limit_low == Approx(-1.3).margin(0.2));
    gui.click("part 1 mirror axis", [&] { gene_table(genome, 1, kinds); });
    CHECK(click(1, "part 1 mirror axis=Depth") == "part 1 mirror axis");
}

TEST_CASE("organs are added to a gene, edited and removed", "[studio][inspector]") {
    TabRun<GenotypeTab> run;
    const KindCatalog& catalog = test::kinds().creature.catalog;
    const auto show = [&](const GenomePtr& genome) {
        Exhibit exhibit = test::crawler_exhibit();
        exhibit.creature = unjudged(genome, exhibit.creature.settings, "");
        REQUIRE(run.studio.playback().show(exhibit));
    };
    EditGenes edit = test::asked<EditGenes>(run.click("Add sound"));
    REQUIRE(edit.genome->nodes[0].organs.size() == 1);
    CHECK(edit.change.place == "part 0 organ 0");
    CHECK(edit.change.to == "new organ sound");
    CHECK(validate(*edit.genome, catalog).empty());
    show(edit.genome);

    run.click("part 0 organ 0 source");
    edit = test::asked<EditGenes>(run.click("part 0 organ 0 source=Local sensor joint"));
    CHECK(edit.genome->nodes[0].organs[0].input.source.kind == SourceKind::kLocalSensor);
    show(edit.genome);
    edit = test::asked<EditGenes>(run.click("part 0 organ 0 band"));
    CHECK(edit.genome->nodes[0].organs[0].parameters[0] == Approx(1.5).margin(0.6));
    CHECK(validate(*edit.genome, catalog).empty());

    const Requests out = run.click("Remove");
    edit = test::asked<EditGenes>(out);
    CHECK(edit.genome->nodes[0].organs.empty());
    CHECK(edit.change.to == "removed");
    CHECK(test::was_asked<FinishGeneEdit>(out));
}

TEST_CASE("a click on an ancestor shows it and keeps the line of descent", "[studio][inspector]") {
    TabRun<AncestryTab> run;
    GeneEditor editor;
    const Exhibit original = run.studio.playback().exhibit();
    Genome changed = *original.genome();
    changed.nodes[0].length = 0.6;
    editor.edit(original, std::make_shared<const Genome>(changed), {"part 0 length", "0.8", "0.6"});
    REQUIRE(run.studio.playback().show(editor.exhibit()));
    const ShowExhibit back = test::asked<ShowExhibit>(run.click("ancestor 1"));
    CHECK(back.exhibit->genome() == original.genome());
    REQUIRE(run.studio.playback().show(*back.exhibit));
    const ShowExhibit again = test::asked<ShowExhibit>(run.click("ancestor 0"));
    CHECK(again.exhibit->individual().method == "edited");
}

TEST_CASE("mutations are described by operator and change", "[studio][inspector]") {
    const MutationRegistry& kinds = test::kinds().mutations;
    CHECK(operator_words({kinds[0].id, "", "", ""}, kinds) == kinds[0].label);
    CHECK(operator_words({"edited", "", "", ""}, kinds) == "Edited by hand");
    CHECK(change_words({"", "", "0.5", "0.62"}) == "0.5 → 0.62");
    CHECK(change_words({"", "", "", "neuron"}) == "neuron");
}

TEST_CASE("the creature on display is held while the pointer is in the inspector's controls",
          "[studio][inspector]") {
    test::PanelRun<InspectorPanel> run(400.0F, 700.0F);
    run.studio.show_crawler();
    run.gui.move_to({200.0F, 10.0F});  // the title
    run.frame();
    run.frame();
    CHECK_FALSE(test::was_asked<HoldShown>(run.out));
    run.gui.move_to({200.0F, 300.0F});
    run.frame();
    CHECK(test::was_asked<HoldShown>(run.out));
}

}  // namespace
}  // namespace cambrian
