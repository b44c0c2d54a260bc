#include "studio/panels/viewport/drawing_strip.h"

#include "math/angle.h"
#include "sketch/part_edits.h"
#include "studio/widgets/value_slider.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr float kNarrowDrawingStrip = 640.0F;  // narrower ones have no labels
constexpr float kTightDrawingStrip = 500.0F;   // and fewer words
constexpr float kToolHeight = 25.0F;
constexpr float kMostSliderWidth = 150.0F;

void strip_label(const char* words) {
    ImGui::AlignTextToFramePadding();
    const WithTextColor muted(colors().muted);
    ImGui::TextUnformatted(words);
    ImGui::SameLine();
}

bool tool_button(const char* label, const char* help, bool enabled,
                 ButtonLook look = ButtonLook::kPlain) {
    const bool pressed = push_button(
        label, {.look = look, .height = px(kToolHeight), .enabled = enabled, .tooltip = help});
    ImGui::SameLine();
    return pressed;
}

bool is_tight_strip() {
    return ImGui::GetWindowWidth() < px(kTightDrawingStrip);
}

void choose_mirror(const FrameContext& frame, bool narrow, Requests& out) {
    static const std::vector<std::string> labels = {"One side", "Left and right",
                                                    "Above and below"};
    const auto chosen = static_cast<std::size_t>(frame.viewer.drawing.mirror);
    if (!narrow) strip_label("New parts");
    if (begin_choice("##mirror", labels[chosen], px(is_tight_strip() ? 104 : 136))) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (choice_line(labels[i], i == chosen))
                out.ask(MirrorNewParts{static_cast<MirrorSides>(i)});
            note_place(labels[i]);
        }
        ImGui::EndCombo();
    }
    note_place("mirror");
    tooltip("Whether a new part gets a mirror image, and where (M)");
    ImGui::SameLine(0, px(12));
}

}  // namespace

struct DrawingStrip::RhythmRow {
    const char* name;
    double Rhythm::*value;
    double low;
    double high;
    double factor;  // to what is shown
    const char* pattern;
    const char* help;
};

void DrawingStrip::draw(const FrameContext& frame, Requests& out) {
    follow(frame);
    const WithFont font(ui().fonts.small);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(6), px(3)));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(8), px(4)));
    draw_part(frame, out);
    ImGui::NewLine();
    draw_rhythm(out);
    ImGui::PopStyleVar(2);
}

void DrawingStrip::follow(const FrameContext& frame) {
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    if (exhibit.genome() == genome_) return;
    genome_ = exhibit.genome();
    const SketchRules rules{frame.kinds.creature, exhibit.settings().expression,
                            exhibit.settings().world.scene};
    sketch_ = sketch_of(*genome_, rules);
    // Rhythms half a cycle apart may be the same genes, so the one that is being set stays.
    if (!sliding_) rhythm_ = rhythm_of(sketch_, rules);
    if (rhythm_) given_ = *rhythm_;
}

void DrawingStrip::draw_part(const FrameContext& frame, Requests& out) const {
    const bool narrow = ImGui::GetWindowWidth() < px(kNarrowDrawingStrip);
    choose_mirror(frame, narrow, out);
    std::optional<std::size_t> part;
    if (frame.viewer.drawing.chosen) part = find_part(sketch_, *frame.viewer.drawing.chosen);
    if (!narrow) strip_label("Chosen part");
    const int repeats = part ? repeats_of(sketch_, *part) : 1;
    if (tool_button("−", "One copy less in a row (-)", part && repeats > 1))
        out.ask(RepeatPart{repeats - 1});
    note_place("repeat less");
    strip_label(fmt::format("{}{}", repeats, is_tight_strip() ? "×" : " in a row").c_str());
    if (tool_button("+", "One copy more, at the end of the last one (+)",
                    part && repeats < gene_range::kMaxRecursion))
        out.ask(RepeatPart{repeats + 1});
    note_place("repeat more");
    const bool is_limb = part && *part > 0;
    const bool paired = is_limb && is_paired(sketch_, *part);
    if (tool_button(paired ? "Keep one side" : "Both sides",
                    paired ? "Keep only the one that was clicked (Shift+M)"
                           : "Give the chosen part a mirror image (Shift+M)",
                    is_limb))
        out.ask(SwitchPair{});
    if (tool_button("Remove", "The chosen part and all that grows from it (Delete)", is_limb))
        out.ask(RemovePart{});
}

void DrawingStrip::draw_rhythm(Requests& out) {
    const bool moves = !sketch_.body.effectors.empty();
    if (!rhythm_) {
        if (tool_button("Give it a rhythm",
                        "All joints swing to one beat, one after the other along the body", moves,
                        moves ? ButtonLook::kPrimary : ButtonLook::kPlain)) {
            out.ask(GiveRhythm{given_});
            out.ask(FinishGeneEdit{});
        }
        const WithTextColor muted(colors().muted);
        ImGui::AlignTextToFramePadding();
        const char* why = !moves ? "Drag from an edge of the part to draw another one."
                          : sketch_.body.has_live_control
                              ? "Its joints follow neurons, whose place the rhythm takes."
                              : "Its joints rest until it has one, or a brain that evolved.";
        ImGui::TextUnformatted(fit_text(why, ImGui::GetContentRegionAvail().x).c_str());
        return;
    }
    static const std::array rows = {
        RhythmRow{"Beat", &Rhythm::frequency, kLeastFrequency, kMostFrequency, 1.0, "%.2f a second",
                  "Swings of each joint in a second"},
        RhythmRow{"Swing", &Rhythm::swing, kLeastRhythmSwing, kMostRhythmSwing, to_degrees(1.0),
                  "%.0f°", "How far each joint swings either way"},
        RhythmRow{"Wave", &Rhythm::wave, -kMostWave, kMostWave, 1.0, "%.2f",
                  "How far the last joint is behind the first, in swings: at 0 all move together, "
                  "at 1 a wave runs through the body"}};
    Rhythm rhythm = *rhythm_;
    bool changed = false;
    for (const RhythmRow& row : rows)
        changed |= rhythm_slider(row, rhythm, out);
    if (!changed) return;
    rhythm_ = rhythm;
    out.ask(GiveRhythm{rhythm});
}

bool DrawingStrip::rhythm_slider(const RhythmRow& row, Rhythm& rhythm, Requests& out) {
    const float room = ImGui::GetWindowWidth() / 3.0F - ImGui::CalcTextSize(row.name).x - px(28);
    strip_label(row.name);
    ImGui::PushID(row.name);
    double shown = rhythm.*row.value * row.factor;
    const SliderRange range = {row.low * row.factor, row.high * row.factor};
    const bool changed =
        value_slider(shown, {.range = range,
                             .pattern = row.pattern,
                             .width = std::clamp(room, px(40), px(kMostSliderWidth)),
                             .allowed = range});
    if (changed) rhythm.*row.value = shown / row.factor;
    if (ImGui::IsItemActivated()) sliding_ = true;
    if (ImGui::IsItemDeactivated()) sliding_ = false;
    if (ImGui::IsItemDeactivatedAfterEdit()) out.ask(FinishGeneEdit{});
    note_place(row.name);
    tooltip(row.help);
    ImGui::PopID();
    ImGui::SameLine(0, px(12));
    return changed;
}

}  // namespace cambrian
