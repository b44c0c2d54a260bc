#pragma once

#include "studio/actions/palette_lines.h"
#include "studio/frame/panel.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace cambrian {

// Finds actions, settings and places of the help by typed words, and goes to the chosen one.
class PalettePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    bool draw_words(const FrameContext& frame);
    void move_by_keys();
    bool draw_line(std::size_t index);

    std::array<char, 100> words_{};
    std::vector<HelpPlace> help_;     // of the pages when the palette was opened
    std::vector<PaletteLine> lines_;  // that match the words
    std::size_t chosen_ = 0;
    bool moved_ = false;  // brings the chosen line into sight
};

}  // namespace cambrian
