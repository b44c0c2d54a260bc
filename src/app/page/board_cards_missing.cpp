#include "app/page/board_cards.h"
#include "app/process/messages.h"

namespace cambrian {

std::vector<std::string> board_cards(const ChallengeBoard& /*board*/,
                                     const EvolutionKinds& /*kinds*/, const TrialWatch& /*watch*/) {
    say("this program was built without pictures; no cards are drawn");
    return {};
}

}  // namespace cambrian
