#include "app/page/board_cards.h"

#include "app/process/messages.h"
#include "persist/creature/creature_card.h"
#include "pictures/card_picture.h"
#include "pictures/workshop.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr int kBoardCardWidth = 360;  // pixels
constexpr int kBoardCardHeight = 480;

}  // namespace

std::vector<std::string> board_cards(const ChallengeBoard& board, const EvolutionKinds& kinds,
                                     const TrialWatch& watch) {
    std::vector<std::string> cards;
    const auto workshop = open_workshop(kBoardCardWidth, kBoardCardHeight);
    if (!workshop) {
        say("no cards are drawn: " + workshop.error().message);
        return cards;
    }
    const std::size_t count = std::min(board.ranked.size(), kMostBoardCards);
    for (std::size_t i = 0; i < count && !watch.stop.stop_requested(); ++i) {
        const BoardEntry& entry = board.ranked[i];
        const CreatureDocument& document = *entry.document;
        const auto subject =
            subject_of(document, document.settings(), entry.name, kinds, {.stop = watch.stop});
        if (!subject) break;
        PictureCanvas& canvas = *(*workshop)->canvas;
        draw_card(canvas, *subject, palette_of(ThemeKind::kLight));
        Result<std::string> card = encode_card(canvas.finish(), write_creature(document, kinds));
        if (!card) break;
        cards.push_back(*std::move(card));
        watch.note(static_cast<double>(i + 1));
    }
    return cards;
}

}  // namespace cambrian
