#include "studio/panels/cards/start_panel.h"

#include "studio/panels/cards/card_title.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <cmath>

namespace cambrian {
namespace {

constexpr float kRunWidth = 234.0F;
constexpr float kRunHeight = 150.0F;
constexpr float kRunGap = 10.0F;

void write_below(const RecentRun& run, const ImVec2& low, const ImVec2& high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    note_letters(run.title);
    const float room = high.x - low.x - px(24);
    list.AddText(ui().fonts.strong, px(15), {low.x + px(12), high.y - px(45)}, paint(colors().text),
                 fit_text(run.title, room).c_str());
    list.AddText(ui().fonts.small, px(13), {low.x + px(12), high.y - px(25)},
                 paint(run.readable ? colors().muted : colors().danger),
                 fit_text(run.account, room).c_str());
}

// A run that can be opened is a button with its champion.
void draw_open_run(const RecentRun& run, Requests& out) {
    const std::string name = "run " + run.title;
    if (ImGui::InvisibleButton(name.c_str(), {px(kRunWidth), px(kRunHeight)}))
        out.ask(OpenRun{run.path});
    note_place(name);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, paint(hovered ? colors().hovered : colors().raised), px(8));
    if (run.champion != nullptr)
        draw_creature_tile(list, {low.x + px(14), low.y + px(12), px(kRunWidth - 28), px(86)},
                           *run.champion, run.hue, run.line);
    write_below(run, low, high);
    tooltip(fmt::format("{}\n{}", run.path.string(), run.account));
}

// Another one says why it cannot be opened, and can be taken off the list.
void draw_lost_run(const RecentRun& run, Requests& out) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = {low.x + px(kRunWidth), low.y + px(kRunHeight)};
    ImGui::BeginGroup();
    ImGui::GetWindowDrawList()->AddRect(low, high, paint(colors().raised), px(8), 0, px(1.5F));
    ImGui::SetCursorScreenPos({low.x + px(12), low.y + px(14)});
    if (push_button("Take off the list", {.height = px(28), .tooltip = "Its file is left alone"}))
        out.ask(ForgetRun{run.path});
    note_place("forget " + run.title);
    write_below(run, low, high);
    ImGui::SetCursorScreenPos(low);
    ImGui::Dummy({px(kRunWidth), px(kRunHeight)});
    ImGui::EndGroup();
    tooltip(fmt::format("{}\n{}", run.path.string(), run.account));
}

void draw_runs(const StartPage& page, Requests& out) {
    if (page.runs.empty())
        muted_text(page.read ? "Runs that you save (Ctrl+K) or open are listed here." : "…");
    const int columns = tiles_across(ImGui::GetContentRegionAvail().x, px(kRunWidth), px(kRunGap));
    int column = 0;
    for (const RecentRun& run : page.runs) {
        if (column % columns != 0) ImGui::SameLine(0, px(kRunGap));
        ++column;
        ImGui::PushID(run.path.c_str());
        run.readable ? draw_open_run(run, out) : draw_lost_run(run, out);
        ImGui::PopID();
    }
}

void draw_challenges(const StartPage& page, Requests& out) {
    if (page.challenges.empty()) return;
    section("Challenges");
    float left = ImGui::GetContentRegionAvail().x;
    for (const std::filesystem::path& path : page.challenges) {
        const std::string file = path.filename().string();
        const std::string name = file.substr(0, file.find('.'));
        const float width = ImGui::CalcTextSize(name.c_str()).x + px(32);
        const bool fits = path != page.challenges.front() && left >= width + px(kRunGap);
        if (fits) ImGui::SameLine(0, px(kRunGap));
        if (!fits) left = ImGui::GetContentRegionAvail().x;
        left -= width + px(kRunGap);
        if (push_button(name, {.width = width,
                               .tooltip = "A goal, a world, a seed and a number of trials that "
                                          "are the same for everybody"}))
            out.ask(LoadFile{path});
    }
}

}  // namespace

void StartPanel::draw(const FrameContext& frame, Requests& out) {
    const bool begun = !frame.experiment.snapshot.history.empty();
    if (card_title("Start", "Close start page", "first_minute", out)) out.ask(ToggleStartPage{});
    if (push_button(begun ? "Go on with the last run" : "Go on", {.look = ButtonLook::kPrimary}))
        out.ask(ToggleStartPage{});
    ImGui::SameLine(0, px(8));
    if (push_button("Begin a new run", {.tooltip = "From random creatures, with another seed"})) {
        out.ask(StartNewRun{});
        out.ask(ToggleStartPage{});
    }
    ImGui::SameLine(0, px(8));
    if (frame.in_space()
            ? push_button("Begin in two dimensions", {.tooltip = "Walkers, jumpers and others"})
            : push_button("Begin in three dimensions", {.tooltip = "A run of swimmers in space"}))
        out.ask(BeginElsewhere{});
    if (frame.may_draw_creature()) {
        ImGui::SameLine(0, px(8));
        if (push_button(
                "Draw a creature",
                {.tooltip = "Draw a body with the mouse, give it a rhythm and evolve it"})) {
            out.ask(DrawNewCreature{});
            out.ask(ToggleStartPage{});
        }
    }
    ImGui::BeginChild("start", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kRunGap), px(kRunGap)));
    section("Recent runs");
    draw_runs(*frame.files.start, out);
    draw_challenges(*frame.files.start, out);
    section("Samples");
    samples_.draw_tiles(*frame.files.samples, out);
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace cambrian
