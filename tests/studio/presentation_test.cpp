#include "studio/presentation.h"

#include "studio/actions/action.h"
#include "studio_fixture.h"
#include "studio_run.h"

#include <GLFW/glfw3.h>

namespace cambrian {
namespace {

using test::StudioRun;

JudgedIndividual judged(std::uint64_t uid, double fitness, std::uint32_t generation) {
    Individual individual;
    individual.uid = uid;
    individual.genome = test::crawler(test::kinds().creature.catalog);
    individual.evaluated = true;
    individual.result.fitness = fitness;
    return {generation, std::make_shared<const Individual>(std::move(individual)),
            std::make_shared<const ExperimentSettings>(test::small_experiment())};
}

std::vector<std::uint64_t> uids_of(const std::vector<Exhibit>& exhibits) {
    std::vector<std::uint64_t> uids;
    for (const Exhibit& exhibit : exhibits)
        uids.push_back(exhibit.individual().uid);
    return uids;
}

TEST_CASE("the best are the starred, then champions that improved, the newest first",
          "[studio][presentation]") {
    const std::vector<JudgedIndividual> champions = {judged(1, 1.0, 0), judged(2, 0.5, 1),
                                                     judged(3, 2.0, 2), judged(3, 2.0, 3),
                                                     judged(4, 3.0, 4)};
    CHECK(uids_of(best_exhibits({}, champions)) == std::vector<std::uint64_t>{4, 3, 1});
    CHECK(uids_of(best_exhibits({judged(9, 0.0, 0), judged(3, 2.0, 2)}, champions)) ==
          std::vector<std::uint64_t>{9, 3, 4, 1});
    CHECK(best_exhibits({}, {}).empty());
}

TEST_CASE("each creature of a presentation is shown until its trial is over, and long enough",
          "[studio][presentation]") {
    Presentation presentation;
    const std::vector<Exhibit> two = best_exhibits({judged(1, 0, 0), judged(2, 0, 0)}, {});
    CHECK(presentation.update(0.0, true) == nullptr);
    presentation.begin(two, best_exhibits({judged(7, 0, 0)}, {}).front());
    const auto shown = [&](double now, bool over) {
        const Exhibit* exhibit = presentation.update(now, over);
        return exhibit == nullptr ? 0 : exhibit->individual().uid;
    };
    CHECK(shown(100.0, false) == 1);
    CHECK(shown(102.0, true) == 0);
    CHECK(shown(110.0, false) == 0);
    CHECK(shown(111.0, true) == 2);
    CHECK(shown(127.0, false) == 1);
    CHECK(presentation.end()->individual().uid == 7);
    CHECK_FALSE(presentation.on());
    CHECK(shown(200.0, true) == 0);
}

TEST_CASE("a presentation fills the display, and any key brings back what was before",
          "[studio][presentation]") {
    StudioRun run;
    test::finish_generations(run, 2);
    const std::uint64_t before = test::shown_in(run).individual().uid;
    const bool newest = run.studio.view().newest_champion;
    run.ask(TogglePresentation{});
    const auto window = [&] { return run.studio.frame_context().window; };
    CHECK(window().presenting);
    CHECK(window().full_screen);
    REQUIRE(run.frames_until([] { return true; }));
    CHECK(test::shown_in(run).source == ExhibitSource::kChampion);
    Requests out;
    press_shortcut({GLFW_KEY_B}, false, run.studio.frame_context(), out);
    CHECK(test::was_asked<TogglePresentation>(out));
    run.studio.carry_out(out);
    CHECK_FALSE(window().presenting);
    CHECK_FALSE(window().full_screen);
    CHECK(test::shown_in(run).individual().uid == before);
    CHECK(run.studio.view().newest_champion == newest);
}

TEST_CASE("a full screen remains after a presentation", "[studio][presentation]") {
    StudioRun run;
    run.ask(ToggleFullScreen{});
    run.ask(TogglePresentation{});
    run.ask(TogglePresentation{});
    CHECK(run.studio.frame_context().window.full_screen);
    run.ask(ToggleFullScreen{});
    CHECK_FALSE(run.studio.frame_context().window.full_screen);
}

TEST_CASE("without champions the samples are presented", "[studio][presentation]") {
    StudioRun run;
    const CreatureDocument document{judged(5, 1.0, 0)};
    REQUIRE(save_creature(run.folder / "crawler.creature.json", document, test::kinds()));
    run.studio.files().use_samples({run.folder.path()});
    run.ask(TogglePresentation{});
    CHECK(run.frames_until([&] { return test::shown_in(run).source == ExhibitSource::kSample; }));
}

}  // namespace
}  // namespace cambrian
