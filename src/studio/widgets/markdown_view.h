#pragma once

#include "studio/widgets/markdown.h"

namespace cambrian {

// Draws a page over the width there is. The link pressed, or empty.
std::string draw_markdown(const std::vector<MarkdownBlock>& blocks);

}  // namespace cambrian
