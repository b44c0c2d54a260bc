#include "studio/widgets/markdown_view.h"

#include "studio/look/ui_context.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

ImFont* font_of(SpanLook look) {
    const Fonts& fonts = ui().fonts;
    if (look == SpanLook::kBold) return fonts.strong;
    return look == SpanLook::kCode ? fonts.mono : fonts.body;
}

// Places words one after the other and breaks lines at a width.
class WordSetter {
public:
    explicit WordSetter(float width)
        : low_(ImGui::GetCursorScreenPos()), width_(width), at_(low_) {}

    void set(const TextSpan& span, ImFont* font, const Color& color) {
        std::size_t start = 0;
        while (start < span.text.size()) {
            const std::size_t end = std::min(span.text.find(' ', start), span.text.size());
            set_word(span, span.text.substr(start, end - start), font, color);
            if (end < span.text.size())
                at_.x += font->CalcTextSizeA(font->FontSize, INFINITY, 0.0F, " ").x;
            start = end + 1;
        }
    }
    // Reserves the space used; returns the link that was clicked.
    std::string finish() {
        ImGui::Dummy({width_, at_.y + line_ - low_.y});
        return link_;
    }

private:
    void set_word(const TextSpan& span, const std::string& word, ImFont* font, const Color& color) {
        const ImVec2 size = font->CalcTextSizeA(font->FontSize, INFINITY, 0.0F, word.c_str());
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

// Returns a column's preferred width, in pixels.
float wanted_width(const MarkdownBlock& table, std::size_t column) {
    float widest = px(24);
    for (const auto& row : table.rows) {
        if (column >= row.size()) continue;
        float width = px(10);
        for (const TextSpan& span : row[column]) {
            ImFont* font = font_of(span.look);
            width += font->CalcTextSizeA(font->FontSize, INFINITY, 0.0F, span.text.c_str()).x;
        }
        widest = std::max(widest, width);
    }
    return std::min(widest, 0.6F * ImGui::GetContentRegionAvail().x);
}

// Makes the words of a table's header bold.
void embolden(std::vector<SpanLine>& cells) {
    for (SpanLine& cell : cells) {
        for (TextSpan& span : cell)
            span.look = SpanLook::kBold;
    }
}

std::string draw_table(const MarkdownBlock& table) {
    std::string pressed;
    const std::size_t columns = table.rows.front().size();
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_BordersInnerH;
    if (columns == 0 || !ImGui::BeginTable("table", static_cast<int>(columns), flags))
        return pressed;
    for (std::size_t column = 0; column < columns; ++column)
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch,
                                wanted_width(table, column));
    for (auto row : table.rows) {
        if (ImGui::TableGetRowIndex() < 0) embolden(row);
        ImGui::TableNextRow();
        for (std::size_t column = 0; column < std::min(columns, row.size()); ++column) {
            ImGui::TableSetColumnIndex(static_cast<int>(column));
            const std::string link = draw_line(row[column], ImGui::GetContentRegionAvail().x);
            if (!link.empty()) pressed = link;
        }
    }
    ImGui::EndTable();
    return pressed;
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
            break;
    }
    return draw_table(block);
}

}  // namespace

std::string draw_markdown(const std::vector<MarkdownBlock>& blocks) {
    std::string pressed;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string link = draw_block(blocks[i], i == 0);
        if (!link.empty()) pressed = link;
        ImGui::PopID();
    }
    return pressed;
}

}  // namespace cambrian
