#pragma once

// The board of a challenge as a file: Markdown or a document for browsers.

#include "comparison/challenge_board.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

// `folder` is that of the board, from which pages are linked.
std::string board_markdown(const ChallengeBoard& board, const std::filesystem::path& folder,
                           const EvolutionKinds& kinds);

// `cards` are PNG files for the first of the ranked entries.
std::string board_html(const ChallengeBoard& board, const std::filesystem::path& folder,
                       const std::vector<std::string>& cards, const EvolutionKinds& kinds);

}  // namespace cambrian
