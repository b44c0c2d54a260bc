#include "studio/probe/text_faults.h"

#include "studio/look/ui_context.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace cambrian {
namespace {

constexpr float kHarmlessShare = 0.15F;  // share of a line's height that may be cut
constexpr float kOverlapShare = 0.25F;   // share of a glyph's box that another may overlap

using TexturePlace = std::tuple<float, float, float, float>;
using Letters = std::map<TexturePlace, unsigned>;

struct Line {
    std::string text;
    std::vector<ImRect> boxes;  // of the line's glyphs
    ImRect all;
    ImRect clip;
};

// Maps positions in the fonts' texture to letters.
Letters letters_of(const ImFontAtlas& atlas) {
    Letters letters;
    for (const ImFont* font : atlas.Fonts) {
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.Visible) letters[{glyph.U0, glyph.V0, glyph.U1, glyph.V1}] = glyph.Codepoint;
    }
    return letters;
}

// Returns whether six indices form a glyph's rectangle, as ImFont::RenderText() writes them.
bool is_quad(const ImDrawIdx* index) {
    const int first = index[0];
    return index[1] == first + 1 && index[2] == first + 2 && index[3] == first &&
           index[4] == first + 2 && index[5] == first + 3;
}

// Returns whether a glyph continues a line, after at most one space.
bool goes_on(const Line& line, const ImRect& box, const ImRect& clip) {
    const ImRect& last = line.boxes.back();
    const float height = line.all.GetHeight();
    const bool level = box.Min.y < line.all.Max.y && box.Max.y > line.all.Min.y;
    const bool next = box.Min.x > last.Min.x && box.Min.x < last.Max.x + 0.7F * height;
    return level && next && clip.Min.x == line.clip.Min.x && clip.Max.x == line.clip.Max.x;
}

// Adds a glyph to its line; an invisible glyph is left out.
void add_letter(std::vector<Line>& lines, const ImRect& box, const ImRect& clip, unsigned code) {
    if (!clip.Overlaps(box)) return;
    if (lines.empty() || !goes_on(lines.back(), box, clip)) {
        lines.push_back({{}, {}, box, clip});
    } else if (box.Min.x - lines.back().boxes.back().Max.x > 0.4F * lines.back().all.GetHeight()) {
        lines.back().text += ' ';
    }
    Line& line = lines.back();
    char bytes[5] = {};
    ImTextCharToUtf8(bytes, code);
    line.text += bytes;
    line.boxes.push_back(box);
    line.all.Add(box);
}

std::vector<Line> lines_of(const ImDrawList& list, const Letters& letters) {
    std::vector<Line> lines;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
        const ImDrawIdx* end = index + command.ElemCount;
        while (end - index >= 6) {
            const ImDrawVert* corner = list.VtxBuffer.Data + command.VtxOffset + *index;
            const auto letter = !is_quad(index) ? letters.end()
                                                : letters.find({corner[0].uv.x, corner[0].uv.y,
                                                                corner[2].uv.x, corner[2].uv.y});
            const bool found = letter != letters.end();
            if (found)
                add_letter(lines, {corner[0].pos, corner[2].pos}, ImRect(command.ClipRect),
                           letter->second);
            index += found ? 6 : 3;
        }
    }
    return lines;
}

bool is_cut(const Line& line, bool scrolled) {
    const ImRect& clip = line.clip;
    const float slack = kHarmlessShare * line.all.GetHeight();
    const bool beside = line.all.Min.x < clip.Min.x - slack || line.all.Max.x > clip.Max.x + slack;
    const bool above_or_below =
        line.all.Min.y < clip.Min.y - slack || line.all.Max.y > clip.Max.y + slack;
    return beside || (above_or_below && !scrolled);
}

bool overlap(const ImRect& a, const ImRect& b) {
    const float width = std::min(a.Max.x, b.Max.x) - std::max(a.Min.x, b.Min.x);
    const float height = std::min(a.Max.y, b.Max.y) - std::max(a.Min.y, b.Min.y);
    if (width <= 0.0F || height <= 0.0F) return false;
    return width * height > kOverlapShare * std::min(a.GetArea(), b.GetArea());
}

// Returns the visible part of a box.
ImRect seen_part(ImRect box, const ImRect& clip) {
    box.ClipWith(clip);
    return box;
}

bool overlap(const Line& a, const Line& b) {
    if (!a.all.Overlaps(b.all)) return false;
    return std::any_of(a.boxes.begin(), a.boxes.end(), [&](const ImRect& box) {
        return std::any_of(b.boxes.begin(), b.boxes.end(), [&](const ImRect& other) {
            return overlap(seen_part(box, a.clip), seen_part(other, b.clip));
        });
    });
}

void add_faults(const ImDrawList& list, const Letters& letters, std::vector<TextFault>& faults) {
    const std::vector<Line> lines = lines_of(list, letters);
    const char* owner = list._OwnerName == nullptr ? "" : list._OwnerName;
    const bool scrolled = scrolls_down(ImGui::FindWindowByName(owner));
    const auto add = [&](TextFaultKind kind, const Line& line, const std::string& other) {
        const ImVec2 size = line.all.GetSize();
        faults.push_back(
            {kind, owner, line.text, other, {line.all.Min.x, line.all.Min.y, size.x, size.y}});
    };
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        if (is_cut(*line, scrolled)) add(TextFaultKind::kCut, *line, "");
        for (auto other = line + 1; other != lines.end(); ++other)
            if (line->text != other->text && overlap(*line, *other))
                add(TextFaultKind::kOverlap, *line, other->text);
    }
}

}  // namespace

std::vector<TextFault> find_text_faults() {
    const ImDrawData& data = *ImGui::GetDrawData();
    const Letters letters = letters_of(*ImGui::GetIO().Fonts);
    std::vector<TextFault> faults;
    for (int i = 0; i < data.CmdListsCount; ++i)
        add_faults(*data.CmdLists[i], letters, faults);
    return faults;
}

}  // namespace cambrian
