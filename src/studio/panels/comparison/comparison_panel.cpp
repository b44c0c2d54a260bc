#include "studio/panels/comparison/comparison_panel.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "studio/experiment/setting_filter.h"
#include "studio/panels/cards/card_title.h"
#include "studio/panels/comparison/comparison_chart.h"
#include "studio/panels/comparison/comparison_table.h"
#include "studio/widgets/value_slider.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr const char* kComparingPage = "comparing";
constexpr float kFieldGap = 12.0F;
constexpr const char* kNothingVaried = "nothing";

// Returns to the row of a group, `width` pixels and a gap further right.
void next_in_row(ImVec2& row, float width) {
    row.x += width + px(kFieldGap);
    ImGui::SetCursorPos(row);
}

// Draws a number with its label above; returns whether it changed.
bool number_field(const char* label, const char* help, int& number, const SliderStyle& style) {
    ImGui::BeginGroup();
    caption(label);
    ImGui::PushID(label);
    const bool changed = value_slider(number, style);
    ImGui::PopID();
    note_place(label);
    tooltip(help);
    ImGui::EndGroup();
    return changed;
}

bool draw_extent(ComparisonDraft& draft) {
    ImVec2 row = ImGui::GetCursorPos();
    const float width = 0.25F * (ImGui::GetContentRegionAvail().x - 2.0F * px(kFieldGap));
    bool changed =
        number_field("Runs of each", "Each run has a seed of its own: 1, 2, 3…", draft.seeds,
                     {.range = {1, ComparisonDraft::kMostSeeds},
                      .width = width,
                      .allowed = SliderRange{1, ComparisonDraft::kMostSeeds}});
    next_in_row(row, width);
    changed |= number_field(
        "Trials of a run", "A run ends with the generation that reaches them", draft.trials,
        {.range = {ComparisonDraft::kFewestTrials, 100'000},
         .logarithmic = true,
         .width = width,
         .allowed = SliderRange{ComparisonDraft::kFewestTrials, ComparisonDraft::kMostTrials}});
    draft.seeds = std::clamp(draft.seeds, 1, ComparisonDraft::kMostSeeds);
    draft.trials =
        std::clamp(draft.trials, ComparisonDraft::kFewestTrials, ComparisonDraft::kMostTrials);
    next_in_row(row, width);
    ImGui::BeginGroup();
    caption("Random search too");
    changed |= toggle_switch("random search", draft.random_search);
    tooltip("A further arm that keeps the best of new random creatures, with as many trials");
    ImGui::EndGroup();
    return changed;
}

std::string progress_words(const ComparisonView& comparison) {
    if (comparison.results == nullptr) return comparison.running ? "Beginning…" : "";
    const ComparisonResults& results = *comparison.results;
    std::string count =
        fmt::format("{} of {}", results.finished(), counted(results.planned_runs(), "run"));
    if (comparison.running) return count;
    if (results.finished() == results.planned_runs()) return "Finished: " + count;
    return fmt::format("Stopped after {}; the same comparison goes on where it was", count);
}

void draw_progress(const ComparisonView& comparison, Requests& out) {
    if (comparison.running) {
        if (push_button("Stop", {.width = px(110), .tooltip = "Keeps the runs that are finished"}))
            out.ask(StopComparison{});
    } else if (push_button("Compare", {.look = ButtonLook::kPrimary,
                                       .width = px(110),
                                       .tooltip = "Evolves in the background, in the world of the "
                                                  "present settings"})) {
        out.ask(BeginComparison{});
    }
    ImGui::SameLine(0, px(kFieldGap));
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    const bool bad = !comparison.problem.empty();
    const WithTextColor color(bad ? colors().danger : colors().muted);
    const std::string words = bad ? comparison.problem : progress_words(comparison);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    note_place("comparison state");
    ImGui::EndGroup();
    if (comparison.running)
        progress_bar(static_cast<float>(comparison.share), 0.0F, px(4));
    else
        ImGui::Dummy({0, px(4)});
}

std::string label_of(const SettingField& field) {
    std::string table = capitalized(field.table);
    std::replace(table.begin(), table.end(), '.', ' ');
    return fmt::format("{}: {}", table, field.label);
}

std::string label_of(const FrameContext& frame, const std::string& varied) {
    const auto& fields = frame.experiment.fields;
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const SettingField& field) {
        return path_of(field) == varied;
    });
    return found == fields.end() ? kNothingVaried : label_of(*found);
}

}  // namespace

void ComparisonPanel::draw(const FrameContext& frame, Requests& out) {
    if (frame.comparison == nullptr) return;
    const ComparisonView& comparison = *frame.comparison;
    if (card_title("Compare settings", "Close the comparison", kComparingPage, out))
        out.ask(ToggleComparison{});
    muted_text(
        "A single run tells little: luck makes equal runs differ severalfold. Here the present "
        "settings evolve several times for each value of one setting, in the background.");
    ImGui::Dummy({0, px(2)});
    ComparisonDraft draft = comparison.draft;
    ImGui::BeginDisabled(comparison.running);
    bool changed = draw_varied(frame, draft);
    changed |= draw_extent(draft);
    ImGui::EndDisabled();
    if (changed && !comparison.running) out.ask(EditComparison{std::move(draft)});
    ImGui::Dummy({0, px(2)});
    draw_progress(comparison, out);
    if (comparison.results == nullptr) {
        if (!comparison.running)
            muted_text("The curves of all arms appear here, and how surely they differ.");
        return;
    }
    const ComparisonResults& results = *comparison.results;
    const float rows =
        static_cast<float>(results.arms.size() + 1) * (ImGui::GetFrameHeightWithSpacing() + px(4)) +
        ImGui::GetTextLineHeightWithSpacing();
    draw_comparison_chart(results, comparison.unit,
                          std::max(px(140), ImGui::GetContentRegionAvail().y - rows));
    draw_comparison_table(results, comparison.unit, out);
    caption(fit_text("Kept in " + comparison.folder, ImGui::GetContentRegionAvail().x));
    tooltip(comparison.folder);
}

bool ComparisonPanel::draw_varied(const FrameContext& frame, ComparisonDraft& draft) {
    ImVec2 row = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x - px(kFieldGap);
    bool changed = draw_choice_of_setting(frame, draft, 0.4F * width);
    next_in_row(row, 0.4F * width);
    ImGui::BeginGroup();
    caption("Values, the first of which is the reference");
    ImGui::SetNextItemWidth(0.6F * width);
    changed |= draw_values(draft);
    ImGui::EndGroup();
    return changed;
}

bool ComparisonPanel::draw_values(ComparisonDraft& draft) {
    if (draft.values != shown_) {
        values_.fill('\0');
        draft.values.copy(values_.data(), kLongest - 1);
        shown_ = draft.values;
    }
    ImGui::BeginDisabled(draft.varied.empty());
    const bool edited =
        ImGui::InputTextWithHint("##values", "choose what to vary", values_.data(), kLongest);
    ImGui::EndDisabled();
    note_place("Values");
    if (edited) shown_ = draft.values = values_.data();
    return edited;
}

bool ComparisonPanel::draw_choice_of_setting(const FrameContext& frame, ComparisonDraft& draft,
                                             float width) {
    ImGui::BeginGroup();
    caption("Vary");
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, px(360)});
    bool changed = false;
    if (begin_choice("##varied", label_of(frame, draft.varied), width)) {
        changed = list_settings(frame, draft);
        ImGui::EndCombo();
    } else {
        note_place("Vary");
    }
    ImGui::EndGroup();
    return changed;
}

bool ComparisonPanel::list_settings(const FrameContext& frame, ComparisonDraft& draft) {
    if (ImGui::IsWindowAppearing()) {
        find_.fill('\0');
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##find", "Find a setting", find_.data(), kLongest);
    const SettingFilter filter(find_.data());
    bool changed = false;
    if (filter.empty() && choice_line(kNothingVaried, draft.varied.empty())) {
        draft.varied.clear();
        draft.values.clear();
        changed = true;
    }
    for (const SettingField& field : frame.experiment.fields) {
        if (!may_vary(field) || !filter.finds(field, field.table)) continue;
        const std::string path = path_of(field);
        ImGui::PushID(path.c_str());
        if (choice_line(label_of(field), path == draft.varied)) {
            draft.varied = path;
            draft.values = suggested_values(field, frame.experiment.editor.draft());
            changed = true;
        }
        ImGui::PopID();
        note_place("vary " + path);
        tooltip(fmt::format("{}\n{}", path, field.help));
    }
    return changed;
}

}  // namespace cambrian
