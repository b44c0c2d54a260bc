#pragma once

#include "comparison/challenge_board.h"
#include "simulator/trial_watch.h"

#include <string>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kMostBoardCards = 50;

// Draws the cards of the first entries of a board, as PNG files with the creatures inside. Without
// a renderer there are none, and it says so. After a stop request there are fewer.
std::vector<std::string> board_cards(const ChallengeBoard& board, const EvolutionKinds& kinds,
                                     const TrialWatch& watch);

}  // namespace cambrian
