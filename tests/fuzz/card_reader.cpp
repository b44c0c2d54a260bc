// Fuzzes creature cards: the reader gives the text inside a picture, or a message. The text is
// written into another card unchanged, and then read as a creature file.

#include "fuzz/fuzz_target.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/creature_file.h"
#include "support/kinds.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

const Image& picture() {
    static const Image small{2, 2, std::vector<std::uint8_t>(12, 90)};
    return small;
}

void carry(const std::string& document) {
    const auto card = encode_card(picture(), document);
    promise(card.has_value(), "what was in a card fits into another");
    const auto again = card_document(*card, "again");
    promise(again.has_value(), "a card that is written can be read");
    promise(*again == document, "a card gives what was put in, byte for byte");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto document = card_document(text_of(data, size), "input");
    if (!document) {
        promise(document.error().message.starts_with("input: "), "a refusal names the file");
        return 0;
    }
    carry(*document);
    const auto creature = parse_creature(*document, "input", kinds());
    promise(creature.has_value() || creature.error().message.starts_with("input: E"),
            "a refusal has a code");
    return 0;
}
