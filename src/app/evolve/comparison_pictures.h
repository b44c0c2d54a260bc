#pragma once

#include "comparison/compared_run.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace cambrian {

// Draws the curves of each world's arms as curves-WORLD.png in the folder. Fails if there is no
// renderer.
Status save_comparison_pictures(const std::filesystem::path& folder,
                                const std::vector<ComparedRun>& runs);

}  // namespace cambrian
