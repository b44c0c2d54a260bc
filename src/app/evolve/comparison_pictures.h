#pragma once

#include "comparison/compared_run.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace cambrian {

// Draws the curves of every world's arms as curves-WORLD.png into the folder. Fails where nothing
// can be drawn.
Status save_comparison_pictures(const std::filesystem::path& folder,
                                const std::vector<ComparedRun>& runs);

}  // namespace cambrian
