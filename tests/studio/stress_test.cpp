// The studio with random requests, as fast as frames can follow. All threads of the studio work
// meanwhile. It is meant mainly for the thread sanitizer:
//
//   cmake --preset tsan && cmake --build build/tsan --target studio_tests
//   CAMBRIAN_STRESS_FRAMES=40000 CAMBRIAN_STRESS_SEED=2 build/tsan/bin/studio_tests '[stress]'

#include "core/random.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "studio_run.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <system_error>

namespace cambrian {
namespace {

using test::StudioRun;

int frames_wanted() {
    const char* asked = std::getenv("CAMBRIAN_STRESS_FRAMES");
    return asked == nullptr ? 1500 : std::atoi(asked);
}

class RestlessPerson {
public:
    RestlessPerson(StudioRun& run, std::uint64_t seed) : run_(run), chance_(seed) {}

    void act() { std::invoke(kActs[chance_.below(kActs.size())], this); }

private:
    FrameContext frame() const { return run_.studio.frame_context(); }
    std::filesystem::path file(const char* name) const { return run_.folder.path() / name; }

    void evolve() { run_.ask(ToggleEvolution{}); }
    void step() { run_.ask(RunOneGeneration{}); }
    void edit() {
        ExperimentSettings draft = frame().experiment.editor.draft();
        draft.world.environment.gravity = chance_.uniform(1.0, 20.0);
        run_.ask(EditSettings{draft, "environment.gravity"});
        if (chance_.chance(0.7)) run_.ask(FinishEdit{});
    }
    void undo() { run_.ask(UndoEdit{}); }
    void redo() { run_.ask(RedoEdit{}); }
    void start_new_run() { run_.ask(StartNewRun{chance_.chance(0.5)}); }
    void add_immigrants() { run_.ask(AddImmigrants{chance_.uniform(0.0, 1.0)}); }
    void show_champion() {
        run_.ask(ShowChampion{static_cast<std::uint32_t>(chance_.below(run_.champions() + 1))});
    }
    void show_newest() { run_.ask(ShowNewest{}); }
    void show_anyone() {
        const EvolutionSnapshot& snapshot = frame().experiment.snapshot;
        if (snapshot.population.empty()) return;
        const std::size_t place = chance_.below(snapshot.population.size());
        run_.ask(ShowIndividual{{snapshot.champions.back().generation, snapshot.population[place],
                                 snapshot.champions.back().settings}});
    }
    void play() { run_.ask(TogglePlayback{}); }
    void seek() { run_.ask(SeekPlayback{chance_.below(60)}); }
    void star() { run_.ask(ToggleStarOfShown{}); }
    void pick_by_hand() { run_.ask(ToggleHandPicking{}); }
    void pick() {
        const PickingView* picking = frame().picking;
        if (picking == nullptr || picking->snapshot.tree.empty()) return;
        const GridNode& grid = picking->snapshot.tree.current();
        run_.ask(AskPicking{TogglePick{grid.number, chance_.below(grid.creatures.size())}});
    }
    void breed() {
        if (frame().picking != nullptr) run_.ask(AskPicking{BreedPicks{}});
    }
    void go_back() {
        if (frame().picking != nullptr) run_.ask(AskPicking{GoBack{}});
    }
    void ask_evolution() {
        if (frame().picking != nullptr) run_.ask(AskPicking{AskEvolution{2}});
    }
    void hand_over() {
        const bool inject = chance_.chance(0.5);
        if (frame().picking != nullptr)
            run_.ask(HandOverPicks{inject ? PicksUse::kInject : PicksUse::kFound});
    }
    void save_creature() { run_.ask(SaveCreatureFile{file("one.creature.json")}); }
    void save_settings() { run_.ask(SaveSettingsFile{file("all.toml")}); }
    void save_statistics() { run_.ask(SaveStatisticsFile{file("run.csv")}); }
    void save_experiment() { run_.ask(SaveExperimentFile{file("run.cambrian")}); }
    void load() {
        constexpr std::array names = {"one.creature.json", "all.toml", "run.cambrian", "run.csv"};
        run_.ask(LoadFile{file(names[chance_.below(names.size())])});
    }
    void list() { run_.ask(ListFolder{run_.folder.path()}); }

    using Act = void (RestlessPerson::*)();
    using P = RestlessPerson;
    static constexpr std::array kActs = {&P::evolve,
                                         &P::evolve,
                                         &P::step,
                                         &P::edit,
                                         &P::undo,
                                         &P::redo,
                                         &P::start_new_run,
                                         &P::add_immigrants,
                                         &P::show_champion,
                                         &P::show_newest,
                                         &P::show_anyone,
                                         &P::play,
                                         &P::seek,
                                         &P::star,
                                         &P::pick_by_hand,
                                         &P::pick,
                                         &P::pick,
                                         &P::breed,
                                         &P::go_back,
                                         &P::ask_evolution,
                                         &P::hand_over,
                                         &P::save_creature,
                                         &P::save_settings,
                                         &P::save_statistics,
                                         &P::save_experiment,
                                         &P::load,
                                         &P::list};

    StudioRun& run_;
    RandomStream chance_;
};

// Returns the messages about files that exist but cannot be read. Which files exist depends on the
// speed of the threads.
std::vector<std::string> unreadable_files(const StudioRun& run) {
    std::vector<std::string> messages;
    const auto read = [&](const char* name, auto load) {
        const std::filesystem::path path = run.folder.path() / name;
        std::error_code none;
        if (!std::filesystem::exists(path, none)) return;
        if (const auto loaded = load(path, test::kinds()); !loaded)
            messages.push_back(loaded.error().message);
    };
    read("one.creature.json", load_creature);
    read("all.toml", [](const std::filesystem::path& path, const EvolutionKinds& evolution) {
        return load_settings(path, evolution);
    });
    read("run.cambrian", load_experiment);
    return messages;
}

bool has_genomes(const std::vector<IndividualPtr>& population) {
    return std::all_of(population.begin(), population.end(),
                       [](const IndividualPtr& each) { return each->genome != nullptr; });
}

// Afterwards the studio still works, once its pending tasks are done.
void check_still_evolving(StudioRun& run) {
    int calm = 0;
    REQUIRE(run.frames_until([&] { return ++calm == 500; }));
    if (run.studio.frame_context().picking != nullptr) run.ask(ToggleHandPicking{});
    const auto experiment = [&run] {
        return run.studio.frame_context().experiment.snapshot.experiment;
    };
    const std::uint64_t before = experiment();
    run.ask(StartNewRun{});
    REQUIRE(run.frames_until([&] { return experiment() > before; }));
    run.ask(RunOneGeneration{});
    CHECK(run.frames_until([&] { return run.champions() == 1; }));
}

}  // namespace

TEST_CASE("the studio handles thousands of random requests",
          "[studio][controller][stress][threads]") {
    StudioRun run;
    run.studio.remember_in(run.folder.path() / "state");
    const char* seed = std::getenv("CAMBRIAN_STRESS_SEED");
    RestlessPerson person(run, seed == nullptr ? 11 : std::strtoull(seed, nullptr, 10));
    RandomStream pace(12);
    const int frames = frames_wanted();
    for (int i = 0; i < frames; ++i) {
        run.studio.update(0.016 * i, 0.016);
        const FrameContext frame = run.studio.frame_context();
        REQUIRE(has_genomes(frame.experiment.snapshot.population));
        if (pace.chance(0.3)) person.act();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(unreadable_files(run) == std::vector<std::string>());
    check_still_evolving(run);
}

}  // namespace cambrian
