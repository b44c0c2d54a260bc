#pragma once

// Pages (persist/page/page_file.h) as commands make them.

#include "app/command_line/command_files.h"
#include "app/process/exit_status.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/page/page_file.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

// Returns what this program's pages are made of. The engine is missing if none was built.
PageParts page_parts();

bool is_page_name(const std::filesystem::path& path);

// Writes a page and prints its size, or says what is wrong.
ExitStatus write_page(const PageContent& content, const std::filesystem::path& path,
                      const EvolutionKinds& kinds);

// Does so with the creatures of files or, if the only one is an experiment, with its champions.
// `files` are those of the command.
ExitStatus make_page_of(const std::vector<std::string>& sources, const std::string& out,
                        const CommandFiles& files, const EvolutionKinds& kinds);

}  // namespace cambrian
