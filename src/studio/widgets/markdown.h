#pragma once

// A parser for the part of Markdown that help pages use: headings, paragraphs, bullets, code,
// tables and pictures; and, within a line, bold, emphasis, code and links.

#include "core/image.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

enum class SpanLook : std::uint8_t { kPlain, kBold, kCode };

struct TextSpan {
    std::string text;
    SpanLook look = SpanLook::kPlain;
    std::string link;  // target of the link, or empty

    friend bool operator==(const TextSpan&, const TextSpan&) = default;
};
using SpanLine = std::vector<TextSpan>;

enum class BlockKind : std::uint8_t { kHeading, kParagraph, kBullet, kCode, kTable, kPicture };

struct MarkdownBlock {
    BlockKind kind = BlockKind::kParagraph;
    int level = 0;                            // of a heading, from 1; of a bullet, from 0
    SpanLine line;                            // text of a heading, paragraph or bullet, or
                                              // what a picture shows
    std::string code;                         // lines of a code block
    std::vector<std::vector<SpanLine>> rows;  // of a table; the first is its header, in bold
    std::string target;                       // file of a picture
    std::shared_ptr<const Image> picture;     // its pixels, once someone has read them
};

// Never fails; unknown syntax becomes plain text.
std::vector<MarkdownBlock> parse_markdown(std::string_view text);
SpanLine parse_spans(std::string_view text);

}  // namespace cambrian
