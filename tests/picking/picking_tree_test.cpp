#include "picking/picking_tree.h"

#include "core/random.h"
#include "support/catch.h"
#include "support/individuals.h"

#include <numeric>
#include <set>

using namespace cambrian;

namespace {

GridNode grid(std::vector<std::size_t> picks = {}) {
    GridNode node;
    node.picks = std::move(picks);
    node.creatures = test::individuals({1.0, 2.0});
    return node;
}

// Performs one random operation.
void wander(PickingTree& tree, RandomStream& stream) {
    switch (stream.below(4)) {
        case 0:
            tree.add(grid({stream.below(2)}));
            break;
        case 1:
            tree.back();
            break;
        case 2:
            tree.forward();
            break;
        default:
            CHECK(tree.visit(static_cast<std::uint32_t>(stream.below(tree.size()))));
    }
}

// The identity of a grid and its creatures, and its parent.
struct Trace {
    const GridNode* node;
    std::optional<std::uint32_t> parent;
    std::vector<IndividualPtr> creatures;

    friend bool operator==(const Trace&, const Trace&) = default;
};

std::vector<Trace> traces(const PickingTree& tree) {
    std::vector<Trace> all;
    for (std::uint32_t i = 0; i < tree.size(); ++i)
        all.push_back({&tree.node(i), tree.node(i).parent, tree.node(i).creatures});
    return all;
}

}  // namespace

TEST_CASE("an empty tree has no grid to go to", "[picking][tree]") {
    PickingTree tree;
    CHECK(tree.empty());
    CHECK_FALSE(tree.back());
    CHECK_FALSE(tree.forward());
    CHECK_FALSE(tree.next());
    CHECK_FALSE(tree.visit(0));
}

TEST_CASE("nothing is lost or changed in thousands of random walks", "[picking][tree]") {
    for (std::uint64_t walk = 0; walk < 3000; ++walk) {
        RandomStream stream(stream_seed({1, walk}));
        PickingTree tree;
        tree.add(grid());
        std::vector<Trace> before = traces(tree);
        for (int step = 0; step < 25; ++step) {
            wander(tree, stream);
            std::vector<Trace> after = traces(tree);
            REQUIRE(after.size() >= before.size());
            REQUIRE(std::equal(before.begin(), before.end(), after.begin()));
            before = std::move(after);
        }
    }
}

TEST_CASE("going forward undoes any number of steps back", "[picking][tree]") {
    for (std::uint64_t walk = 0; walk < 1000; ++walk) {
        RandomStream stream(stream_seed({2, walk}));
        PickingTree tree;
        tree.add(grid());
        for (int step = 0; step < 20; ++step)
            wander(tree, stream);
        const std::uint32_t start = tree.current().number;
        std::size_t steps = stream.below(6);
        std::vector<std::uint32_t> way = {start};
        while (steps-- > 0 && tree.back())
            way.push_back(tree.current().number);
        for (std::size_t i = way.size() - 1; i-- > 0;) {
            REQUIRE(tree.forward());
            REQUIRE(tree.current().number == way[i]);
        }
    }
}

TEST_CASE("back always ends at the first grid", "[picking][tree]") {
    RandomStream stream(3);
    PickingTree tree;
    tree.add(grid());
    for (int step = 0; step < 500; ++step)
        wander(tree, stream);
    while (tree.back()) {
    }
    CHECK(tree.current().number == 0);
}

TEST_CASE("breeding again from an earlier grid makes a branch", "[picking][tree]") {
    PickingTree tree;
    tree.add(grid());
    tree.add(grid({0}));
    tree.add(grid({1}));
    REQUIRE(tree.visit(0));
    tree.add(grid({1, 0}));
    CHECK(tree.node(1).parent == 0U);
    CHECK(tree.node(2).parent == 1U);
    CHECK(tree.node(3).parent == 0U);
    CHECK(tree.current().number == 3);
    CHECK(tree.current().picks == std::vector<std::size_t>{1, 0});
    REQUIRE(tree.back());
    CHECK(tree.next() == 3U);
}

TEST_CASE("after a visit, going forward follows the branch of the visited grid",
          "[picking][tree]") {
    PickingTree tree;
    tree.add(grid());
    tree.add(grid());
    tree.add(grid());
    REQUIRE(tree.visit(0));
    tree.add(grid());  // a branch, to which forward() now leads
    REQUIRE(tree.visit(2));
    REQUIRE(tree.back());
    REQUIRE(tree.back());
    REQUIRE(tree.forward());
    CHECK(tree.current().number == 1);
    CHECK_FALSE(tree.visit(4));
    CHECK(tree.current().number == 1);
}

TEST_CASE("every grid descends from the first one, and copies of a tree share grids",
          "[picking][tree]") {
    RandomStream stream(4);
    PickingTree tree;
    tree.add(grid());
    for (int step = 0; step < 400; ++step)
        wander(tree, stream);
    const PickingTree copy = tree;
    for (std::uint32_t number = 0; number < tree.size(); ++number)
        CHECK(&copy.node(number) == &tree.node(number));
    CHECK_FALSE(tree.node(0).parent);
    for (std::uint32_t number = 1; number < tree.size(); ++number)
        CHECK(tree.node(number).parent.value_or(number) < number);
    tree.add(grid());
    CHECK(copy.size() + 1 == tree.size());
}

TEST_CASE("a tree can have a path of ten thousand grids", "[picking][tree]") {
    PickingTree tree;
    for (int i = 0; i < 10000; ++i) {
        GridNode node;
        tree.add(std::move(node));
    }
    CHECK(tree.size() == 10000);
    CHECK(tree.current().number == 9999);
}
