#include "studio/panels/inspector/ancestry_tab.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "genome/creature_name.h"
#include "studio/viewer/mutation_words.h"
#include "studio/viewer/origin_words.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

constexpr float kAncestorHeight = 76.0F;
constexpr float kRowGap = 5.0F;
constexpr float kPictureWidth = 70.0F;
constexpr int kAncestorsGrown = 6;

std::string breeding_words(const Individual& individual, const EvolutionKinds& kinds) {
    std::string words = method_words(individual.method, kinds);
    if (individual.parents[1] != 0) words += " with another parent";
    return words;
}

// Returns the place of the first mutation and the number of further ones.
std::string place_line(const Individual& individual, const EvolutionKinds& kinds) {
    if (individual.mutations.empty()) return breeding_words(individual, kinds);
    const std::string& place = individual.mutations.front().place;
    const std::size_t others = individual.mutations.size() - 1;
    return others == 0 ? place : fmt::format("{}  +{}", place, others);
}

std::string change_line(const Individual& individual) {
    return individual.mutations.empty() ? std::string()
                                        : change_words(individual.mutations.front());
}

// Returns the fitness from the evaluation. A displayed creature that was never evaluated has the
// score of the displayed trial.
std::string fitness_words(const Individual& individual, const FrameContext& frame) {
    if (individual.evaluated) return pretty_number(individual.result.fitness);
    const bool shown = frame.viewer.playback.exhibit().genome() == individual.genome;
    return shown && frame.viewer.score != nullptr ? pretty_number(frame.viewer.score->score.value)
                                                  : "not judged";
}

std::string born_words(const Individual& individual, const Exhibit& head) {
    const std::string name = creature_name(*individual.genome);
    if (individual.method == "edited") return name + ", edited by hand";
    // It was not bred in any experiment known here.
    if (head.experiment == 0) return "The original";
    return fmt::format("{}, generation {}", name, individual.born);
}

std::string length_words(std::size_t steps) {
    if (steps == 0) return "From the creature to its first ancestor.";
    return fmt::format("{} to its first ancestor; click one to show it.", counted(steps, "step"));
}

std::string step_words(const Individual& individual, const EvolutionKinds& kinds) {
    std::string words = breeding_words(individual, kinds);
    if (individual.evaluated) words += "\nFitness " + pretty_number(individual.result.fitness);
    for (const MutationRecord& mutation : individual.mutations) {
        words += fmt::format("\n{}, {}: {}", operator_words(mutation, kinds.mutations),
                             mutation.place, change_words(mutation));
    }
    return words;
}

std::string gained_words(const AncestryStep& step) {
    if (!step.gained) return {};
    if (*step.gained == 0.0) return "±0";
    return (*step.gained > 0.0 ? "+" : "") + pretty_number(*step.gained);
}

// A line of small text with a shorter text at its right.
struct RowLine {
    std::string text;
    Color color;
    std::string right;
    Color right_color;
};

void draw_line(const RowLine& line, float left, float right, float y) {
    const WithFont font(ui().fonts.small);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = ImGui::CalcTextSize(line.right.c_str()).x;
    const std::string text = fit_text(line.text, right - left - width - px(8));
    list.AddText({left, y}, paint(line.color), text.c_str());
    list.AddText({right - width, y}, paint(line.right_color), line.right.c_str());
}

void draw_words(const AncestryStep& step, const std::string& born, const FrameContext& frame,
                const ImVec2& low, const ImVec2& high) {
    const Individual& individual = *step.individual;
    const std::string fitness = fitness_words(individual, frame);
    const Palette& p = colors();
    const bool gained = step.gained && *step.gained > 0.0;
    const float left = low.x + px(kPictureWidth + 12);
    const float right = high.x - px(10);
    draw_line({born, p.text, gained_words(step), gained ? p.accent : p.muted}, left, right,
              low.y + px(10));
    draw_line({place_line(individual, frame.kinds), p.muted, {}, p.muted}, left, right,
              low.y + px(30));
    draw_line({change_line(individual), p.muted, fitness, p.text}, left, right, low.y + px(50));
}

void end_of_line(const Individual& oldest) {
    if (oldest.parents[0] != 0) {
        muted_text(fmt::format("Nothing more is known of this line; its parent was {}.",
                               uid_text(oldest.parents[0])));
    } else {
        muted_text(oldest.method == "random" ? "The line begins with this random creature."
                                             : "The line begins with this creature.");
    }
}

}  // namespace

void AncestryTab::follow(const Exhibit& shown) {
    const bool known = std::any_of(line_.begin(), line_.end(), [&](const AncestryStep& step) {
        return step.individual->genome == shown.genome();
    });
    if (known) return;
    head_ = std::make_shared<const Exhibit>(shown);
    line_ = ancestry_of(shown);
}

void AncestryTab::draw(const FrameContext& frame, Requests& out) {
    follow(frame.viewer.playback.exhibit());
    bodies_.begin_frame(kAncestorsGrown);
    muted_text(length_words(line_.size() - 1));
    ImGui::BeginChild("line", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(kRowGap)));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(line_.size()), px(kAncestorHeight + kRowGap));
    while (clipper.Step()) {
        for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
            draw_step(static_cast<std::size_t>(row), frame, out);
    }
    ImGui::PopStyleVar();
    end_of_line(*line_.back().individual);
    ImGui::EndChild();
}

void AncestryTab::draw_step(std::size_t index, const FrameContext& frame, Requests& out) {
    const AncestryStep& step = line_[index];
    const Individual& individual = *step.individual;
    const std::string name = fmt::format("ancestor {}", index);
    const float width = ImGui::GetContentRegionAvail().x;
    if (ImGui::InvisibleButton(name.c_str(), {width, px(kAncestorHeight)})) {
        out.ask(ShowExhibit{index == 0 ? head_
                                       : std::make_shared<const Exhibit>(ancestor_exhibit(
                                             *head_, line_, index, frame.experiment.snapshot))});
    }
    if (index < 4) note_place(name);
    tooltip(step_words(individual, frame.kinds));
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Color back =
        ImGui::IsItemHovered() ? colors().hovered : mix(colors().panel, colors().raised, 0.6F);
    list.AddRectFilled(low, high, paint(back), px(5));
    if (frame.viewer.playback.exhibit().genome() == individual.genome)
        list.AddRect(low, high, paint(colors().accent), px(5), ImDrawFlags_None, px(2));
    draw_body(index, frame, low);
    draw_words(step, born_words(individual, *head_), frame, low, high);
}

void AncestryTab::draw_body(std::size_t index, const FrameContext& frame, const ImVec2& at) {
    const GenomePtr& genome = line_[index].individual->genome;
    const Phenotype* phenotype = bodies_.find(
        genome, frame.kinds.creature, head_->settings().expression, head_->settings().world.scene);
    if (phenotype == nullptr) return;
    const Rect area = {at.x + px(8), at.y + px(8), px(kPictureWidth - 8), px(kAncestorHeight - 16)};
    draw_creature_tile(*ImGui::GetWindowDrawList(), area, *phenotype, genome->hue,
                       head_->individual().line);
}

}  // namespace cambrian
