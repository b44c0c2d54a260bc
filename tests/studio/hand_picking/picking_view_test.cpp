#include "studio/hand_picking/picking_view.h"

#include "studio/hand_picking/picking_map.h"
#include "support/catch.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

GridNode bred_from(std::vector<std::size_t> picks) {
    GridNode grid;
    grid.picks = std::move(picks);
    return grid;
}

TEST_CASE("every size of grid is as near to a square as possible", "[studio][picking]") {
    CHECK(grid_columns(4) == 2);
    CHECK(grid_columns(6) == 3);
    CHECK(grid_columns(12) == 4);
    CHECK(grid_columns(25) == 5);
}

TEST_CASE("the map grows to the right and branches downwards", "[studio][picking]") {
    PickingTree tree;
    tree.add(bred_from({}));   // 0
    tree.add(bred_from({1}));  // 1
    tree.add(bred_from({2}));  // 2
    REQUIRE(tree.back());
    tree.add(bred_from({3}));  // 3, a branch of 1
    REQUIRE(tree.visit(0));
    tree.add(bred_from({4}));  // 4, a branch of 0
    tree.add(bred_from({5}));  // 5
    CHECK(lay_out_map(tree) ==
          std::vector<MapPlace>{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 2}, {2, 2}});
}

TEST_CASE("picks are numbered in their order", "[studio][picking]") {
    PickingSnapshot snapshot;
    snapshot.picks = {7, 2};
    CHECK(pick_number(snapshot, 7) == 1);
    CHECK(pick_number(snapshot, 2) == 2);
    CHECK(pick_number(snapshot, 0) == 0);
}

TEST_CASE("the status line describes the state of picking", "[studio][picking]") {
    PickingSnapshot snapshot;
    CHECK(picking_words(snapshot) == "Making the first grid");
    snapshot.tree.add(bred_from({}));
    CHECK(picking_words(snapshot) == "Click the creatures you like");
    snapshot.picks = {0};
    snapshot.children_ready = true;
    CHECK(picking_words(snapshot) == "Enter breeds; the children are ready");
    snapshot.status = PickingStatus::kEvolving;
    snapshot.generations_done = 3;
    snapshot.generations_asked = 10;
    CHECK(picking_words(snapshot) == "Evolving: 3 of 10 generations");
    snapshot.message = "this is the first grid";
    CHECK(picking_words(snapshot) == "This is the first grid");
}

TEST_CASE("a long list of changes is cut short and says so", "[studio][picking]") {
    Individual creature;
    creature.method = "asexual";
    const MutationKind& kind = test::kinds().mutations[0];
    creature.mutations.assign(8, {kind.id, "part 2 length", "0.4", "0.5"});
    const std::string words = change_words(creature, test::kinds());
    CHECK(words.starts_with("Asexual\n" + kind.label + ": part 2 length 0.4 → 0.5\n"));
    CHECK(words.ends_with("\nand 2 more"));
}

}  // namespace
}  // namespace cambrian
