#include "studio/panels/cards/samples_panel.h"

#include "studio/panels/cards/card_title.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/panel_keys.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kSampleWidth = 172.0F;
constexpr float kSampleHeight = 138.0F;
constexpr float kSampleGap = 10.0F;

bool draw_tile(const Sample& sample, const SampleLibrary& library, bool aimed, Requests& out) {
    const std::string name = "sample " + sample.title;
    ImGui::PushID(sample.path.c_str());
    const bool pressed =
        ImGui::InvisibleButton(name.c_str(), {px(kSampleWidth), px(kSampleHeight)});
    ImGui::PopID();
    note_place(name);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsItemHovered();
    list.AddRectFilled(low, high, paint(hovered ? colors().hovered : colors().raised), px(8));
    if (aimed) list.AddRect(low, high, paint(colors().accent), px(8), 0, px(2));
    const bool watched = library.watched == sample.path;
    if (hovered != watched) out.ask(WatchSample{hovered ? sample.path : std::filesystem::path()});
    const Rect picture = {low.x + px(14), low.y + px(12), px(kSampleWidth - 28), px(76)};
    const GridMotion* motion = watched ? library.motion : nullptr;
    if (motion != nullptr && ui().look != LookMode::kMechanics && !motion->cell(0).empty()) {
        draw_moving_tile(list, picture, motion->cell(0), *sample.creature.individual,
                         motion->time(), motion->environment().has_ground);
    } else {
        draw_creature_tile(list, picture, *sample.phenotype, sample.hue, 0);
    }
    list.AddText(ui().fonts.strong, px(15), {low.x + px(12), high.y - px(45)}, paint(colors().text),
                 fit_text(sample.title, px(kSampleWidth - 28)).c_str());
    list.AddText(ui().fonts.small, px(13), {low.x + px(12), high.y - px(25)}, paint(colors().muted),
                 fit_text(sample.account, px(kSampleWidth - 24)).c_str());
    tooltip(fmt::format("{}: {}\nDisplays it in the world it was scored in.", sample.title,
                        sample.account));
    return pressed;
}

void draw_museum_title() {
    ImGui::Dummy({0, px(4)});
    caption("Your museum: the best of each run, one of each body plan");
    note_place("museum");
}

}  // namespace

void SamplesPanel::move_by_keys(std::size_t count, int columns) {
    int at = static_cast<int>(aimed_);
    if (panel_key(ImGuiKey_RightArrow)) ++at;
    if (panel_key(ImGuiKey_LeftArrow)) --at;
    if (panel_key(ImGuiKey_DownArrow)) at += columns;
    if (panel_key(ImGuiKey_UpArrow)) at -= columns;
    const int most = static_cast<int>(count) - 1;
    aimed_ = static_cast<std::size_t>(std::clamp(at, 0, std::max(0, most)));
}

void SamplesPanel::draw_tiles(const SampleLibrary& library, Requests& out) {
    const int columns =
        tiles_across(ImGui::GetContentRegionAvail().x, px(kSampleWidth), px(kSampleGap));
    const auto whole = static_cast<std::size_t>(
        std::count_if(library.samples.begin(), library.samples.end(),
                      [](const Sample& each) { return each.phenotype != nullptr; }));
    move_by_keys(whole, columns);
    const bool entered = panel_key(ImGuiKey_Enter);
    std::size_t first = 0;  // of the program's or of the museum's
    for (std::size_t i = 0; i < whole; ++i) {
        if (library.samples[i].of_museum && (i == 0 || !library.samples[i - 1].of_museum)) {
            first = i;
            draw_museum_title();
        }
        if (static_cast<int>(i - first) % columns != 0) ImGui::SameLine(0, px(kSampleGap));
        const bool aimed = i == aimed_;
        if (!draw_tile(library.samples[i], library, aimed, out) && !(aimed && entered)) continue;
        out.ask(LoadFile{library.samples[i].path});
        if (library.open) out.ask(ToggleSamples{});
    }
    if (whole == library.samples.size()) return;
    ImGui::Dummy({0, px(4)});
    caption("These cannot be opened:");
    for (std::size_t i = whole; i < library.samples.size(); ++i)
        muted_text(library.samples[i].account);
    note_place("damaged samples");
}

void SamplesPanel::draw(const FrameContext& frame, Requests& out) {
    if (card_title("Samples", "Close samples", nullptr, out)) out.ask(ToggleSamples{});
    muted_text("Creatures that were evolved before, each in the world it was scored in.");
    ImGui::BeginChild("samples", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kSampleGap), px(kSampleGap)));
    if (frame.files.samples != nullptr) {
        if (frame.files.samples->read && frame.files.samples->samples.empty())
            muted_text("The folder of samples is empty or missing.");
        draw_tiles(*frame.files.samples, out);
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace cambrian
