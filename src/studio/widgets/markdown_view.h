#pragma once

#include "studio/widgets/markdown.h"

namespace cambrian {

// Draws a page over the available width. Returns the link that was clicked, or an empty string.
std::string draw_markdown(const std::vector<MarkdownBlock>& blocks);

}  // namespace cambrian
