// The scripted users of picking/README.md 2 test whether selection by hand steers evolution.
#include "picking/body_backend.h"
#include "picking/creatures.h"
#include "picking/picking_session.h"
#include "support/catch.h"

#include <algorithm>
#include <functional>

using namespace cambrian;
using test::BodyBackend;
using test::kinds;

namespace {

constexpr int kRuns = 21;
constexpr int kMostDecisions = 60;

using Taste = std::function<double(const EvaluationResult&)>;

double parts(const EvaluationResult& result) {
    return result.parts;
}
double height(const EvaluationResult& result) {
    return result.behavior.settled_height;
}

class Robot {
public:
    explicit Robot(std::uint64_t seed) : session_(settings_of(seed), kinds()) {
        obey(StartFromCreatures{{test::hopper()}});
    }
    void obey(PickingCommand command) {
        session_.apply(std::move(command));
        REQUIRE(session_.snapshot().message.empty());
        while (session_.has_work())
            REQUIRE(session_.work(backend_, progress_, {}));
    }
    double start(const Taste& taste) const {
        return taste(session_.snapshot().tree.node(0).creatures[0]->result);
    }
    double best(const Taste& taste) const { return taste(creatures()[favourite(taste)]->result); }
    // Picks its favourite creature and breeds.
    void decide(const Taste& taste) {
        const std::uint32_t node = session_.snapshot().tree.current().number;
        obey(TogglePick{node, favourite(taste)});
        obey(BreedPicks{});
    }

private:
    static SettingsPtr settings_of(std::uint64_t seed) {
        auto settings = std::make_shared<ExperimentSettings>();
        settings->seed = seed;
        return settings;
    }
    const std::vector<IndividualPtr>& creatures() const {
        return session_.snapshot().tree.current().creatures;
    }
    std::size_t favourite(const Taste& taste) const {
        const auto& all = creatures();
        const auto most = std::max_element(
            all.begin(), all.end(),
            [&](const auto& a, const auto& b) { return taste(a->result) < taste(b->result); });
        return static_cast<std::size_t>(most - all.begin());
    }

    BodyBackend backend_;
    EvaluationProgress progress_;
    PickingSession session_;
};

// Returns the number of decisions until the grid has a creature of the wanted quality.
int decisions_until(Robot& robot, const Taste& taste, double wanted) {
    int decisions = 0;
    for (; robot.best(taste) < wanted && decisions < kMostDecisions; ++decisions)
        robot.decide(taste);
    return decisions;
}

struct Spread {
    int median = 0;
    int worst = 0;
};

Spread spread_of(const std::function<int(std::uint64_t seed)>& run) {
    std::vector<int> all;
    for (int i = 0; i < kRuns; ++i)
        all.push_back(run(static_cast<std::uint64_t>(i) + 1));
    std::sort(all.begin(), all.end());
    return {all[kRuns / 2], all.back()};
}

}  // namespace

TEST_CASE("a simulated user who prefers many parts has 14 after at most 10 decisions",
          "[picking][robot]") {
    const Spread decisions = spread_of([](std::uint64_t seed) {
        Robot robot(seed);
        REQUIRE(robot.start(parts) == 2.0);
        return decisions_until(robot, parts, 14.0);
    });
    CAPTURE(decisions.median, decisions.worst);
    CHECK(decisions.median <= 10);
    CHECK(decisions.worst < kMostDecisions);
}

TEST_CASE("a simulated user who prefers tall creatures has one six times as tall after 8 decisions",
          "[picking][robot]") {
    const Spread decisions = spread_of([](std::uint64_t seed) {
        Robot robot(seed);
        return decisions_until(robot, height, 6.0 * robot.start(height));
    });
    CAPTURE(decisions.median, decisions.worst);
    CHECK(decisions.median <= 8);
    CHECK(decisions.worst < kMostDecisions);
}

TEST_CASE("a simulated user without a preference does not reach 14 parts", "[picking][robot]") {
    const Taste any = [](const EvaluationResult&) { return 0.0; };  // always picks the first cell
    const Spread most_parts = spread_of([&](std::uint64_t seed) {
        Robot robot(seed);
        for (int i = 0; i < 10; ++i)
            robot.decide(any);
        return static_cast<int>(robot.best(parts));
    });
    CHECK(most_parts.median < 14);
}
