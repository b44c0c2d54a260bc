#include "studio/widgets/markdown_view.h"

#include "studio/look/ui_context.h"
#include "studio/widgets/column_widths.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

ImFont* font_of(SpanLook look) {
    const Fonts& fonts = ui().fonts;
    if (look == SpanLook::kBold) return fonts.strong;
    return look == SpanLook::kCode ? fonts.mono : fonts.body;
}

ImVec2 text_size(ImFont* font, const std::string& text) {
    return font->CalcTextSizeA(font->FontSize, INFINITY, 0.0F, text.c_str());
}

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        words.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return words;
}

// Places words one after the other and breaks lines at a width.
class WordSetter {
public:
    explicit WordSetter(float width)
        : low_(ImGui::GetCursorScreenPos()), width_(width), at_(low_) {}

    void set(const TextSpan& span, ImFont* font, const Color& color) {
        const std::vector<std::string> words = words_of(span.text);
        const float space = text_size(font, " ").x;
        for (std::size_t i = 0; i < words.size(); ++i) {
            set_word(span, words[i], font, color);
            if (i + 1 < words.size() || span.text.back() == ' ') at_.x += space;
        }
    }
    // Reserves the space used; returns the link that was clicked.
    std::string finish() {
        ImGui::Dummy({width_, at_.y + line_ - low_.y});
        return link_;
    }

private:
    void set_word(const TextSpan& span, const std::string& word, ImFont* font, const Color& color) {
        const ImVec2 size = text_size(font, word);
        if (at_.x > low_.x && at_.x + size.x > low_.x + width_) {
            at_ = {low_.x, at_.y + line_};
        }
        line_ = std::max(line_, std::round(1.3F * size.y));
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 high = {at_.x + size.x, at_.y + size.y};
        list.AddText(font, font->FontSize, at_, paint(span.link.empty() ? color : colors().accent),
                     word.c_str());
        if (!span.link.empty() && ImGui::IsWindowHovered() &&
            ImGui::IsMouseHoveringRect(at_, high)) {
            list.AddLine({at_.x, high.y}, high, paint(colors().accent));
            ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
            if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) link_ = span.link;
        }
        at_.x += size.x;
    }

    ImVec2 low_;
    float width_;
    ImVec2 at_;
    float line_ = ImGui::GetTextLineHeight();
    std::string link_;
};

std::string draw_line(const SpanLine& line, float width) {
    WordSetter setter(width);
    for (const TextSpan& span : line) {
        const Color color = span.look == SpanLook::kCode
                                ? mix(colors().text, colors().accent, 0.35F)
                                : colors().text;
        setter.set(span, font_of(span.look), color);
    }
    return setter.finish();
}

std::string draw_heading(const MarkdownBlock& block, bool first) {
    if (!first) ImGui::Dummy({0, px(block.level < 3 ? 8.0F : 2.0F)});
    WordSetter setter(ImGui::GetContentRegionAvail().x);
    ImFont* font = block.level < 2 ? ui().fonts.title : ui().fonts.strong;
    for (const TextSpan& span : block.line)
        setter.set(span, font, colors().text);
    return setter.finish();
}

std::string draw_bullet(const MarkdownBlock& block) {
    const float indent = px(16) * static_cast<float>(block.level + 1);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float middle = at.y + 0.6F * ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + indent - px(9), middle}, px(2.2F),
                                                paint(colors().muted));
    ImGui::Indent(indent);
    std::string link = draw_line(block.line, ImGui::GetContentRegionAvail().x);
    ImGui::Unindent(indent);
    return link;
}

void draw_code(const std::string& code) {
    const WithFont font(ui().fonts.mono);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 text = ImGui::CalcTextSize(code.c_str(), nullptr, false, width - px(20));
    const ImVec2 size = {width, text.y + px(16)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, paint(colors().raised), px(6));
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + px(10), low.y + px(8)},
                 paint(colors().text), code.c_str(), nullptr, width - px(20));
    ImGui::Dummy(size);
}

// Returns the widths of a column's content, with the space between columns.
ColumnContent content_of(const std::vector<std::vector<SpanLine>>& rows, std::size_t column) {
    ColumnContent content;
    for (const auto& row : rows) {
        if (column >= row.size()) continue;
        float width = 0.0F;
        for (const TextSpan& span : row[column]) {
            ImFont* font = font_of(span.look);
            width += text_size(font, span.text).x;
            for (const std::string& word : words_of(span.text))
                content.longest_word = std::max(content.longest_word, text_size(font, word).x);
        }
        content.longest_text = std::max(content.longest_text, width);
    }
    const float space = px(14);
    content.longest_word += space;
    content.longest_text += space;
    return content;
}

std::string draw_table(const MarkdownBlock& table) {
    std::string pressed;
    std::vector<ColumnContent> contents;
    for (std::size_t column = 0; column < table.rows.front().size(); ++column)
        contents.push_back(content_of(table.rows, column));
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_BordersInnerH;
    if (contents.empty() || !ImGui::BeginTable("table", static_cast<int>(contents.size()), flags))
        return pressed;
    for (const float width : column_widths(contents, ImGui::GetContentRegionAvail().x))
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch, width);
    for (const auto& row : table.rows) {
        ImGui::TableNextRow();
        for (std::size_t column = 0; column < std::min(contents.size(), row.size()); ++column) {
            ImGui::TableSetColumnIndex(static_cast<int>(column));
            const std::string link = draw_line(row[column], ImGui::GetContentRegionAvail().x);
            if (!link.empty()) pressed = link;
        }
    }
    ImGui::EndTable();
    return pressed;
}

// Draws a picture no wider than the page or, if it cannot be shown, what it would show.
std::string draw_picture(const MarkdownBlock& block) {
    const float width = ImGui::GetContentRegionAvail().x;
    if (block.picture && ui().texture_of) {
        const auto wide = static_cast<float>(block.picture->width);
        const float shown = std::min(wide, width);
        ImGui::Image(ui().texture_of(block.picture),
                     {shown, shown * static_cast<float>(block.picture->height) / wide});
        return {};
    }
    SpanLine line = {{"Picture, not shown here: ", SpanLook::kPlain, {}}};
    line.insert(line.end(), block.line.begin(), block.line.end());
    line.push_back({" (", SpanLook::kPlain, {}});
    line.push_back({block.target, SpanLook::kCode, {}});
    line.push_back({")", SpanLook::kPlain, {}});
    return draw_line(line, width);
}

std::string draw_block(const MarkdownBlock& block, bool first) {
    switch (block.kind) {
        case BlockKind::kHeading:
            return draw_heading(block, first);
        case BlockKind::kParagraph:
            return draw_line(block.line, ImGui::GetContentRegionAvail().x);
        case BlockKind::kBullet:
            return draw_bullet(block);
        case BlockKind::kCode:
            draw_code(block.code);
            return {};
        case BlockKind::kTable:
            return draw_table(block);
        case BlockKind::kPicture:
            break;
    }
    return draw_picture(block);
}

}  // namespace

std::string draw_markdown(const std::vector<MarkdownBlock>& blocks, const MarkedBlock& mark) {
    std::string pressed;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool marked = i == mark.index && i > 0;
        const ImVec2 low = ImGui::GetCursorScreenPos();
        if (marked) ImGui::Indent(px(10));
        const std::string link = draw_block(blocks[i], i == 0);
        if (marked) ImGui::Unindent(px(10));
        if (marked) {
            const Rect bar = {low.x, low.y, px(3), ImGui::GetCursorScreenPos().y - low.y - px(6)};
            ImGui::GetWindowDrawList()->AddRectFilled(bar.low(), bar.high(), paint(colors().accent),
                                                      px(1.5F));
            note_place("## marked block", bar);
            if (mark.scroll) ImGui::SetScrollFromPosY(low.y - ImGui::GetWindowPos().y, 0.2F);
        }
        if (!link.empty()) pressed = link;
        ImGui::PopID();
    }
    return pressed;
}

}  // namespace cambrian
