#pragma once

// Creature cards, *.card.png: a picture of a creature with its creature file inside, as a text
// chunk. Any bytes are safe to read.

#include "core/image.h"
#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::string_view kCardKeyword = "cambrian-creature";
inline constexpr std::string_view kCardEnding = ".card.png";
inline constexpr std::string_view kCreatureEnding = ".creature.json";
inline constexpr std::size_t kMaxCardBytes = 16'000'000;

// `document` is text made by write_creature().
Result<std::string> encode_card(const Image& picture, std::string_view document);
Status save_card(const std::filesystem::path& path, const Image& picture,
                 std::string_view document);

// Returns whether a file is a PNG picture, as cards are. Fails if it cannot be read.
Result<bool> is_card(const std::filesystem::path& path);

// Returns the text of the creature file inside, byte for byte. `source` names the card in messages.
Result<std::string> card_document(std::string_view bytes, std::string_view source);

}  // namespace cambrian
