#pragma once

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"

#include <filesystem>
#include <string>

namespace cambrian {

// Writes each creature of a preserve's museum as a creature file in a folder, which is made if it
// does not exist. Returns their names, one per line. Fails if the museum is empty, or a file has
// such a name already; then nothing is written.
Result<std::string> export_museum(const std::string& file, const std::filesystem::path& folder,
                                  const EvolutionKinds& kinds);

}  // namespace cambrian
