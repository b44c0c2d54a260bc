#include "studio/widgets/markdown.h"

#include <algorithm>

namespace cambrian {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t'))
        text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\r'))
        text.remove_suffix(1);
    return text;
}

std::size_t indent_of(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

bool is_bullet(std::string_view bare) {
    return bare.starts_with("- ") || bare.starts_with("* ");
}

bool is_numbered(std::string_view bare) {
    const std::size_t digits = std::min(bare.find_first_not_of("0123456789"), bare.size());
    return digits > 0 && bare.substr(digits).starts_with(". ");
}

// Returns the cells of "| a | b |". A bar after a backslash is text.
std::vector<SpanLine> cells_of(std::string_view row) {
    std::vector<SpanLine> cells;
    std::string cell;
    row.remove_prefix(1);
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] == '\\' && i + 1 < row.size() && row[i + 1] == '|') {
            cell += row[++i];
        } else if (row[i] == '|') {
            cells.push_back(parse_spans(trimmed(cell)));
            cell.clear();
        } else {
            cell += row[i];
        }
    }
    if (!trimmed(cell).empty()) cells.push_back(parse_spans(trimmed(cell)));
    return cells;
}

void embolden(std::vector<SpanLine>& cells) {
    for (SpanLine& cell : cells) {
        for (TextSpan& span : cell)
            span.look = SpanLook::kBold;
    }
}

bool is_rule(std::string_view row) {
    return row.find_first_not_of("|-: ") == std::string_view::npos;
}

// Parses a page line by line.
class PageReader {
public:
    void read(std::string_view line) {
        const std::string_view bare = trimmed(line);
        if (bare.starts_with("```")) {
            finish();
            fenced_ = !fenced_;
        } else if (fenced_ || (indent_of(line) >= 4 && !bare.empty() && text_.empty())) {
            add_code(fenced_ ? line : line.substr(4));
        } else if (bare.empty()) {
            finish();
        } else if (bare.starts_with('#')) {
            add_heading(bare);
        } else if (bare.starts_with('|')) {
            add_row(bare);
        } else if (!take_picture(bare)) {
            add_text(line, bare);
        }
    }
    std::vector<MarkdownBlock> take() {
        finish();
        return std::move(blocks_);
    }

private:
    // Ends the present paragraph or bullet.
    void finish() {
        if (!text_.empty()) {
            MarkdownBlock& block = blocks_.emplace_back();
            block.kind = kind_;
            block.level = level_;
            block.line = parse_spans(text_);
            text_.clear();
        }
        whole_ = true;
    }
    bool goes_on(BlockKind kind) const {
        return !whole_ && !blocks_.empty() && blocks_.back().kind == kind;
    }
    void add_code(std::string_view line) {
        if (!goes_on(BlockKind::kCode)) {
            finish();
            blocks_.emplace_back().kind = BlockKind::kCode;
        } else {
            blocks_.back().code += '\n';
        }
        blocks_.back().code += line;
        whole_ = false;
    }
    void add_heading(std::string_view bare) {
        finish();
        const std::size_t level = std::min(bare.find_first_not_of('#'), bare.size());
        MarkdownBlock& heading = blocks_.emplace_back();
        heading.kind = BlockKind::kHeading;
        heading.level = static_cast<int>(level);
        heading.line = parse_spans(trimmed(bare.substr(level)));
    }
    void add_row(std::string_view bare) {
        if (is_rule(bare)) return;
        if (!goes_on(BlockKind::kTable)) {
            finish();
            blocks_.emplace_back().kind = BlockKind::kTable;
        }
        auto& rows = blocks_.back().rows;
        rows.push_back(cells_of(bare));
        if (rows.size() == 1) embolden(rows.front());
        whole_ = false;
    }
    // Takes a line that is "![what it shows](file)". Returns false if it is not.
    bool take_picture(std::string_view bare) {
        if (!bare.starts_with("![") || !bare.ends_with(')')) return false;
        const std::size_t middle = bare.find("](");
        if (middle == std::string_view::npos) return false;
        finish();
        MarkdownBlock& picture = blocks_.emplace_back();
        picture.kind = BlockKind::kPicture;
        picture.line = parse_spans(bare.substr(2, middle - 2));
        picture.target = bare.substr(middle + 2, bare.size() - middle - 3);
        return true;
    }
    void add_text(std::string_view line, std::string_view bare) {
        if (is_bullet(bare)) {
            finish();
            kind_ = BlockKind::kBullet;
            level_ = static_cast<int>(indent_of(line) / 2);
            bare = trimmed(bare.substr(2));
        } else if (is_numbered(bare) || text_.empty()) {
            finish();
            kind_ = BlockKind::kParagraph;
            level_ = 0;
        }
        if (!text_.empty()) text_ += ' ';
        text_ += bare;
    }

    std::vector<MarkdownBlock> blocks_;
    BlockKind kind_ = BlockKind::kParagraph;  // kind of the block being read
    int level_ = 0;
    std::string text_;
    bool fenced_ = false;
    bool whole_ = true;  // nothing can be added to the last block
};

// Returns the text up to and including a closing mark; empty if there is none.
std::string_view up_to(std::string_view& rest, std::string_view mark) {
    const std::size_t end = rest.find(mark, mark.size());
    if (end == std::string_view::npos) return {};
    const std::string_view inside = rest.substr(mark.size(), end - mark.size());
    rest.remove_prefix(end + mark.size());
    return inside;
}

bool take_link(std::string_view& rest, SpanLine& spans) {
    const std::size_t middle = rest.find("](");
    const std::size_t end = middle == std::string_view::npos ? middle : rest.find(')', middle);
    if (end == std::string_view::npos) return false;
    for (TextSpan span : parse_spans(rest.substr(1, middle - 1))) {
        span.link = rest.substr(middle + 2, end - middle - 2);
        spans.push_back(std::move(span));
    }
    rest.remove_prefix(end + 1);
    return true;
}

bool take_marked(std::string_view& rest, SpanLine& spans) {
    if (rest.starts_with('[')) return take_link(rest, spans);
    struct Mark {
        std::string_view text;
        SpanLook look;
    };
    for (const Mark& mark :
         {Mark{"**", SpanLook::kBold}, Mark{"`", SpanLook::kCode}, Mark{"*", SpanLook::kBold}}) {
        if (!rest.starts_with(mark.text)) continue;
        const std::string_view inside = up_to(rest, mark.text);
        if (inside.empty()) return false;
        spans.push_back({std::string(inside), mark.look, {}});
        return true;
    }
    return false;
}

}  // namespace

SpanLine parse_spans(std::string_view text) {
    SpanLine spans;
    std::string plain;
    const auto finish = [&] {
        if (!plain.empty()) spans.push_back({plain, SpanLook::kPlain, {}});
        plain.clear();
    };
    while (!text.empty()) {
        if (std::string_view("[*`").find(text.front()) != std::string_view::npos) {
            SpanLine marked;
            if (take_marked(text, marked)) {
                finish();
                spans.insert(spans.end(), marked.begin(), marked.end());
                continue;
            }
        }
        plain += text.front();
        text.remove_prefix(1);
    }
    finish();
    return spans;
}

std::vector<MarkdownBlock> parse_markdown(std::string_view text) {
    PageReader reader;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.read(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.take();
}

}  // namespace cambrian
