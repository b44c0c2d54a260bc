#pragma once

// The studio without a window, whose frames are run by a test.

#include "studio/studio_controller.h"
#include "studio_fixture.h"
#include "support/temporary_directory.h"

#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>

namespace cambrian::test {

inline ExperimentSettings small_experiment() {
    ExperimentSettings settings;
    settings.population.size = 6;
    settings.world.trial.duration = 0.5;
    settings.world.trial.settle_limit = 0.0;
    return settings;
}

class StudioRun {
public:
    explicit StudioRun(MachineOptions machines = {.threads = {.workers = 2}},
                       ClusterMemory cluster = {})
        : studio({{}, small_experiment(), {}, std::move(cluster)}, kinds(), machines,
                 folder.path() / "log") {}

    template <class Action>
    void ask(Action action) {
        Requests requests;
        requests.ask(std::move(action));
        studio.carry_out(requests);
    }
    // Runs frames until a condition holds; gives up after 100 000.
    bool frames_until(const std::function<bool()>& holds) {
        for (int i = 0; i < 100'000; ++i) {
            studio.update(0.001 * i, 0.001);
            if (holds()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    std::size_t champions() const {
        return studio.frame_context().experiment.snapshot.champions.size();
    }
    std::string log() const {
        std::ostringstream text;
        text << std::ifstream(folder.path() / "log").rdbuf();
        return text.str();
    }

    TemporaryDirectory folder;
    StudioController studio;
};

// Runs until so many generations are finished.
inline void finish_generations(StudioRun& run, std::size_t count) {
    while (run.champions() < count) {
        const std::size_t before = run.champions();
        run.ask(RunOneGeneration{});
        REQUIRE(run.frames_until([&] { return run.champions() == before + 1; }));
        REQUIRE(run.frames_until([&] {
            return run.studio.frame_context().experiment.snapshot.status == EngineStatus::kPaused;
        }));
    }
}

inline const Exhibit& shown_in(const StudioRun& run) {
    return run.studio.frame_context().viewer.playback.exhibit();
}

}  // namespace cambrian::test
