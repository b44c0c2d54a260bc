// The window of a program built with one.
#include "app/messages.h"
#include "app/window.h"
#include "studio/studio.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

namespace cambrian {
namespace {

namespace fs = std::filesystem;

// The first creature, by name, that comes with the program; empty if there is none.
fs::path sample_creature() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& assets : {program / "../share/cambrian", fs::path(CAMBRIAN_ASSETS)}) {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(assets / "creatures", error)) {
            if (entry.path().string().ends_with(".creature.json")) found.push_back(entry.path());
        }
        if (!found.empty()) return *std::min_element(found.begin(), found.end());
    }
    return {};
}

// Where what the window remembers is kept; empty if the system names no place.
fs::path state_directory() {
    // Before any thread starts.
    if (const char* state = std::getenv("XDG_STATE_HOME")) {  // NOLINT(concurrency-mt-unsafe)
        return fs::path(state) / "cambrian";
    }
    if (const char* home = std::getenv("HOME")) {  // NOLINT(concurrency-mt-unsafe)
        return fs::path(home) / ".local/state/cambrian";
    }
    return {};
}

}  // namespace

Status display_status() {
    if (display_available()) return {};
    return Error{"there is no display to open a window on"};
}

ExitStatus run_window(const WindowOptions& options, const EvolutionKinds& kinds) {
    StudioOptions studio;
    studio.open_file = options.file;
    studio.status_log = options.status_log;
    studio.frame_log = options.frame_log;
    studio.sample_creature = sample_creature();
    studio.state_dir = state_directory();
    if (Status done = run_studio(studio, kinds); !done) {
        return fail(done.error(), ExitStatus::kFailed);
    }
    return ExitStatus::kDone;
}

}  // namespace cambrian
