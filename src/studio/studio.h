#pragma once

// The window program: a person sets up a world, watches creatures evolve and keeps the ones they
// like.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "pictures/canvas/palette.h"
#include "studio/host/window.h"
#include "studio/machines/machine_options.h"

#include <cstddef>
#include <filesystem>
#include <optional>

namespace cambrian {

struct StudioOptions {
    std::filesystem::path open_file;        // creature or settings; empty for none
    std::filesystem::path assets;           // folder of help pages and samples
    std::filesystem::path sample_creature;  // shown at first unless open_file is one
    std::filesystem::path frame_log;        // CSV of frame times; empty for none
    std::filesystem::path status_log;       // a JSON line for each event, appended; or empty
    std::filesystem::path screenshot;       // PNG of the window at the end; or empty
    double quit_after = 0.0;                // s; 0 stays open
    bool viewer = false;                    // the viewport and its transport alone
    std::optional<ThemeKind> theme;         // instead of the one remembered
    bool evolve = false;                    // begins evolving at once
    int width = 1280;                       // of the window, in units of 1/96 inch
    int height = 800;
    double scale = 0.0;  // of everything drawn; 0 is the display's
    MachineOptions machines;
    std::filesystem::path state_dir;  // what is remembered between runs; empty remembers nothing
};

// Returns when the window is closed. Fails, in one line, without a display or OpenGL.
Status run_studio(const StudioOptions& options, const EvolutionKinds& kinds);

}  // namespace cambrian
