#include "studio/viewer/gene_editor.h"

#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

Exhibit crawler_on_show() {
    Individual individual;
    individual.genome = test::crawler(test::kinds().creature.catalog);
    individual.uid = 0xff;
    individual.method = "crossover";
    individual.evaluated = true;
    return {.creature = {.individual = std::make_shared<const Individual>(individual),
                         .settings = std::make_shared<const ExperimentSettings>()},
            .title = "Crawler"};
}

GenomePtr with_length(const GenomePtr& genome, double length) {
    Genome changed = *genome;
    changed.nodes[1].length = length;
    return std::make_shared<const Genome>(changed);
}

// Edits a length several times, like the drag of a slider.
void drag(GeneEditor& editor, const Exhibit& shown, std::initializer_list<double> lengths) {
    double last = shown.genome()->nodes[1].length;
    for (const double length : lengths) {
        editor.edit(shown, with_length(shown.genome(), length),
                    {"part 1 length", std::to_string(last), std::to_string(length)});
        last = length;
    }
    editor.finish();
}

TEST_CASE("an edited creature is the child of the original", "[studio][gene_editor]") {
    const Exhibit original = crawler_on_show();
    GeneEditor editor;
    drag(editor, original, {0.9});
    const Exhibit shown = editor.exhibit();
    const Individual& edited = shown.individual();
    CHECK(edited.genome->nodes[1].length == 0.9);
    CHECK(edited.method == "edited");
    CHECK(edited.parents == std::array<std::uint64_t, 2>{0xff, 0});
    CHECK(edited.mother.get() == original.creature.individual);
    CHECK(shown.result() == nullptr);
    CHECK(shown.ticks.empty());
    CHECK_FALSE(shown.ancestry);  // an edited creature has no known ancestry
    CHECK(edited.uid != 0xff);
    REQUIRE(edited.mutations.size() == 1);
    CHECK(edited.mutations[0].place == "part 1 length");
}

TEST_CASE("a drag is one step, described from its first value to its last",
          "[studio][gene_editor]") {
    const Exhibit original = crawler_on_show();
    GeneEditor editor;
    drag(editor, original, {0.5, 0.6, 0.7});
    REQUIRE(editor.exhibit().individual().mutations.size() == 1);
    CHECK(editor.exhibit().individual().mutations[0].from == std::to_string(0.4));
    CHECK(editor.exhibit().individual().mutations[0].to == std::to_string(0.7));
    editor.undo();
    CHECK_FALSE(editor.can_undo());
    CHECK(editor.exhibit().genome() == original.genome());
    CHECK(editor.exhibit().individual().method == "crossover");
    CHECK(editor.exhibit().result());
    editor.redo();
    CHECK(editor.exhibit().genome()->nodes[1].length == 0.7);
}

TEST_CASE("an edit after an undo replaces the undone edits", "[studio][gene_editor]") {
    const Exhibit original = crawler_on_show();
    GeneEditor editor;
    drag(editor, original, {0.5});
    drag(editor, editor.exhibit(), {0.6});
    editor.undo();
    REQUIRE(editor.can_redo());
    drag(editor, editor.exhibit(), {1.1});
    CHECK_FALSE(editor.can_redo());
    editor.undo();
    CHECK(editor.exhibit().genome()->nodes[1].length == 0.5);
}

TEST_CASE("a gene edited back to what it was leaves the original", "[studio][gene_editor]") {
    const Exhibit original = crawler_on_show();
    GeneEditor editor;
    drag(editor, original, {0.5});
    drag(editor, editor.exhibit(), {0.4});
    CHECK(editor.exhibit().individual().method == "crossover");
    CHECK(editor.exhibit().individual().mutations.empty());
}

}  // namespace
}  // namespace cambrian
