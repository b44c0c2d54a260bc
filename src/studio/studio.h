#pragma once

// The window program, in which a person sets up a world, watches creatures evolve and saves them.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/page/page_file.h"
#include "pictures/canvas/palette.h"
#include "studio/host/window.h"
#include "studio/look/view_state.h"
#include "studio/machines/machine_options.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <stop_token>

namespace cambrian {

// The way in which the window is drawn.
struct WindowDrawing {
    int width = 1280;  // size of the window, in units of 1/96 inch
    int height = 800;
    double scale = 0.0;        // pixels per 1/96 inch; 0 takes the display's
    double frame_rate = 60.0;  // Hz; most frames a second
};

struct StudioOptions {
    std::filesystem::path open_file;  // any file that the studio opens; empty for none
    std::filesystem::path assets;     // folder of help pages and samples
    PageParts page_parts;             // what saved pages are made of
    std::filesystem::path frame_log;  // CSV file of frame times; empty for none
    // File to which events are appended as JSON lines; empty for none.
    std::filesystem::path status_log;
    std::filesystem::path screenshot;  // PNG file of the window at the end; empty for none
    double quit_after = 0.0;           // s; 0 keeps the window open
    std::stop_token end;               // a stop request closes the window
    bool viewer = false;               // shows only the viewport and its transport bar
    std::optional<ThemeKind> theme;    // replaces the stored theme
    std::optional<Scenery> scenery;    // the same
    bool evolve = false;               // starts evolution at once
    WindowDrawing drawing;
    MachineOptions machines;
    // Folder of the state stored between runs; empty stores nothing.
    std::filesystem::path state_dir;
};

// Runs until the window is closed, in the world of the file to open or the one of last time. Fails
// without a display or OpenGL; the error has one line.
Status run_studio(const StudioOptions& options, const EvolutionKinds& plane,
                  const EvolutionKinds& space);

}  // namespace cambrian
