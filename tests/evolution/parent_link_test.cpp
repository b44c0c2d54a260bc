#include "evolution/individual/parent_link.h"

#include "evolution/evolution.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"

#include <set>
#include <thread>

using namespace cambrian;

namespace {

IndividualPtr child_of(IndividualPtr mother) {
    auto child = std::make_shared<Individual>();
    child->uid = mother == nullptr ? 1 : mother->uid + 1;
    child->mother = ParentLink(std::move(mother));
    return child;
}

IndividualPtr line_of(int length) {
    IndividualPtr last;
    for (int i = 0; i < length; ++i)
        last = child_of(std::move(last));
    return last;
}

// Returns a population of that size after so many generations, with fitness from a formula.
Evolution evolved(int size, int generations) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = size;
    settings->founders.max_nodes = 2;
    settings->founders.max_node_neurons = 1;
    test::FakeBackend backend;
    return test::evolved(settings, backend, generations);
}

}  // namespace

TEST_CASE("a line of any length is freed without recursion", "[evolution][parent_link]") {
    IndividualPtr last = line_of(100'000);
    const std::weak_ptr<const Individual> first = [&] {
        IndividualPtr one = last;
        while (one->mother.get() != nullptr)
            one = one->mother.get();
        return one;
    }();
    CHECK_FALSE(first.expired());
    last.reset();
    CHECK(first.expired());
}

TEST_CASE("a shared ancestor lives as long as one of its lines", "[evolution][parent_link]") {
    IndividualPtr ancestor = line_of(3);
    const std::weak_ptr<const Individual> watched = ancestor;
    IndividualPtr one = child_of(ancestor);
    IndividualPtr other = child_of(std::move(ancestor));
    one.reset();
    REQUIRE_FALSE(watched.expired());
    CHECK(watched.lock()->mother.get()->uid == 2);
    other.reset();
    CHECK(watched.expired());
}

TEST_CASE("two threads may free one line", "[evolution][parent_link]") {
    IndividualPtr one = child_of(line_of(20'000));
    IndividualPtr other = child_of(one->mother.get());
    const std::weak_ptr<const Individual> shared = one->mother.get();
    {
        const std::jthread thread([mine = std::move(one)]() mutable { mine.reset(); });
        other.reset();
    }
    CHECK(shared.expired());
}

TEST_CASE("every creature bred keeps its line to a founder", "[evolution][parent_link]") {
    const Evolution evolution = evolved(40, 12);
    for (IndividualPtr one : evolution.population()) {
        while (one->mother.get() != nullptr) {
            CHECK(one->mother.get()->uid == one->parents[0]);
            CHECK(one->mother.get()->evaluated);
            CHECK(one->mother.get()->born < one->born);
            one = one->mother.get();
        }
        CHECK(one->method == "random");
    }
}

TEST_CASE("lines that died out are forgotten", "[evolution][parent_link]") {
    constexpr int size = 60;
    constexpr int generations = test::by_build(100, 40);
    const Evolution evolution = evolved(size, generations);
    std::set<const Individual*> kept;
    for (IndividualPtr one : evolution.population()) {
        for (; one != nullptr; one = one->mother.get())
            kept.insert(one.get());
    }
    CHECK(kept.size() > static_cast<std::size_t>(size));
    CHECK(kept.size() < static_cast<std::size_t>(size * generations / 8));
}
