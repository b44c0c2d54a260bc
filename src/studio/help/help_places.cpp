#include "studio/help/help_places.h"

namespace cambrian {
namespace {

void add_text(const SpanLine& line, std::string& text) {
    for (const TextSpan& span : line)
        text += span.text;
}

std::string block_text(const MarkdownBlock& block) {
    std::string text = block.code;
    add_text(block.line, text);
    for (const auto& row : block.rows) {
        for (const SpanLine& cell : row) {
            if (!text.empty()) text += &cell == row.data() ? '\n' : ' ';
            add_text(cell, text);
        }
    }
    return text;
}

}  // namespace

std::vector<HelpPlace> help_places(const HelpIndex& index) {
    std::vector<HelpPlace> places;
    for (const HelpPage& page : index.pages) {
        std::string heading = page.title;
        for (std::size_t i = 0; i < page.blocks.size(); ++i) {
            const MarkdownBlock& block = page.blocks[i];
            if (block.kind == BlockKind::kPicture) continue;
            std::string text = block_text(block);
            if (block.kind == BlockKind::kHeading) heading = text;
            places.push_back({page.name, page.title, heading, i, std::move(text)});
        }
    }
    return places;
}

}  // namespace cambrian
