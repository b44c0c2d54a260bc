#pragma once

#include "studio/widgets/markdown.h"

namespace cambrian {

// A block with a mark at its left, unless it is the first. The page is scrolled to it on demand.
struct MarkedBlock {
    std::size_t index = 0;
    bool scroll = false;
};

// Draws a page over the available width. Returns the link that was clicked, or an empty string.
std::string draw_markdown(const std::vector<MarkdownBlock>& blocks, const MarkedBlock& mark = {});

}  // namespace cambrian
