#pragma once

#include "app/exit_status.h"
#include "core/result.h"
#include "evolution/evolution_kinds.h"

#include <string>

namespace cambrian {

// What `cambrian studio` may ask of the window.
struct WindowOptions {
    std::string file;        // creature or settings to open; empty: a sample
    std::string status_log;  // file for one JSON object a line about what goes on; empty: none
    std::string frame_log;   // file for frame times; empty: none
};

// Whether a window can be opened here; if not, why.
Status display_status();

// The studio, until its window is closed.
ExitStatus run_window(const WindowOptions& options, const EvolutionKinds& kinds);

}  // namespace cambrian
