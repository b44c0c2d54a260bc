#include "studio/panels/cards/help_panel.h"

#include "studio/panels/cards/card_title.h"
#include "studio/widgets/markdown_view.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <filesystem>

namespace cambrian {
namespace {

void draw_list(const HelpIndex& index, Requests& out) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, px(2)));
    for (const HelpPage& page : index.pages) {
        const bool open = page.name == index.open;
        const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(28)};
        if (ImGui::InvisibleButton(page.name.c_str(), size)) out.ask(ShowHelp{page.name});
        note_place("help " + page.name);
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 high = ImGui::GetItemRectMax();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (open || ImGui::IsItemHovered()) {
            const Color back =
                open ? mix(colors().raised, colors().accent, 0.3F) : colors().hovered;
            list.AddRectFilled(low, high, paint(back), px(5));
        }
        list.AddText({low.x + px(10), 0.5F * (low.y + high.y - ImGui::GetFontSize())},
                     paint(open ? colors().text : colors().muted),
                     fit_text(page.title, size.x - px(16)).c_str());
        if (ImGui::CalcTextSize(page.title.c_str()).x > size.x - px(16)) tooltip(page.title);
    }
    ImGui::PopStyleVar();
}

// Follows a link to another help page. Links out of the program are not followed.
void follow(const std::string& link, Requests& out) {
    const std::filesystem::path path(link.substr(0, link.find('#')));
    if (path.extension() == ".md") out.ask(ShowHelp{path.stem().string()});
}

}  // namespace

void HelpPanel::draw(const FrameContext& frame, Requests& out) {
    if (card_title("Help", "Close help", nullptr, out)) out.ask(ToggleHelp{});
    if (frame.guide.help == nullptr) return;
    const HelpIndex& index = *frame.guide.help;
    ImGui::BeginChild("pages", {px(190), 0}, false, ImGuiWindowFlags_NoBackground);
    draw_list(index, out);
    ImGui::EndChild();
    ImGui::SameLine(0, px(18));
    ImGui::BeginChild("page", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    const bool asked = asked_ != frame.guide.help_asked;
    if (asked) ImGui::SetScrollY(0.0F);
    if (const HelpPage* page = index.open_page()) {
        asked_ = frame.guide.help_asked;
        follow(draw_markdown(page->blocks, {frame.guide.help_block, asked}), out);
    } else {
        muted_text(fmt::format("There is no page called \"{}\" in the help folder.", index.open));
    }
    ImGui::EndChild();
}

}  // namespace cambrian
