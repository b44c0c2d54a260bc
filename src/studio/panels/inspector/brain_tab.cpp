#include "studio/panels/inspector/brain_tab.h"

#include "core/text/pretty_text.h"
#include "studio/panels/inspector/network_drawing.h"
#include "studio/widgets/plot.h"
#include "studio/widgets/value_slider.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr std::size_t kNodesInRow = 7;
constexpr float kBrainRowHeight = 46.0F;
constexpr float kTraceHeight = 13.0F;
constexpr float kTraceWidth = 32.0F;
constexpr float kHistoryHeight = 132.0F;  // history and force slider of the chosen node
constexpr double kForceRange = 2.0;       // range of the slider; larger values can be typed
constexpr double kMostForce = 10.0;

std::vector<double> history_of(const BrainNode& node, const SignalTrace& signals) {
    if (node.kind == BrainNodeKind::kEffector) return signals.of_output(node.index);
    return signals.of_slot(static_cast<Slot>(node.index));
}

double value_of(const BrainNode& node, const Brain& brain) {
    if (node.kind == BrainNodeKind::kEffector) return brain.output(node.index);
    return brain.value(static_cast<Slot>(node.index));
}

// Draws values over ticks, the newest at the right, zero in the middle.
void draw_trace(ImDrawList& list, const Rect& area, const std::vector<double>& values,
                const Color& color, float width) {
    double most = 1.0;
    std::vector<double> ticks;
    for (const double value : values) {
        ticks.push_back(static_cast<double>(SignalTrace::kLength - values.size() + ticks.size()));
        most = std::max(most, std::fabs(value));
    }
    const PlotScale scale{area, 0.0, static_cast<double>(SignalTrace::kLength - 1), -most, most};
    list.AddRectFilled(area.low(), area.high(), paint(mix(colors().panel, colors().raised, 0.6F)),
                       px(3));
    const float zero = std::floor(scale.y_at(0.0)) + 0.5F;
    list.AddLine({area.x, zero}, {area.x + area.width, zero}, paint(colors().border));
    if (values.size() > 1) draw_curve(list, scale, ticks, values, color, width);
}

}  // namespace

void BrainTab::rebuild(const FrameContext& frame) {
    phenotype_ = frame.viewer.playback.creature().shared_phenotype();
    graph_ = brain_graph(*phenotype_, frame.kinds.creature, kNodesInRow);
    if (chosen_ >= graph_.nodes.size()) chosen_ = 0;
}

void BrainTab::draw(const FrameContext& frame, Requests& out) {
    if (phenotype_ != frame.viewer.playback.creature().shared_phenotype()) rebuild(frame);
    muted_text("Sensors on top, joints at the bottom. Orange is positive, blue negative.");
    const float room = ImGui::GetContentRegionAvail().y - px(kHistoryHeight);
    ImGui::BeginChild("network", {0, std::max(px(2 * kBrainRowHeight), room)}, false,
                      ImGuiWindowFlags_NoBackground);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 inside = ImGui::GetContentRegionAvail();
    const float height =
        std::max(inside.y - px(4), static_cast<float>(graph_.row_count) * px(kBrainRowHeight));
    const Rect area = {at.x, at.y, inside.x, height};
    draw_links(*ImGui::GetWindowDrawList(), graph_, area);
    draw_nodes(area, frame, out);
    ImGui::SetCursorScreenPos({at.x, at.y + height});
    ImGui::EndChild();
    if (chosen_ >= graph_.nodes.size()) return;
    draw_history(frame);
    draw_force(frame, out);
}

void BrainTab::draw_nodes(const Rect& area, const FrameContext& frame, Requests& out) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Brain& brain = frame.viewer.playback.trial().creature().brain();
    const float radius = px(8);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        const BrainNode& node = graph_.nodes[i];
        const ImVec2 at = point_of(graph_, area, i);
        ImGui::SetCursorScreenPos({at.x - radius, at.y - radius});
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::InvisibleButton("node", {2 * radius, 2 * radius + px(kTraceHeight)}))
            chosen_ = i;
        ImGui::PopID();
        note_place(fmt::format("brain node {}", i));
        const double value = value_of(node, brain);
        const bool lit =
            node.part >= 0 &&
            frame.viewer.highlight.covers(static_cast<std::size_t>(node.part),
                                          phenotype_->parts[static_cast<std::size_t>(node.part)]);
        const bool forced = is_forced(frame, node);
        draw_trace(list,
                   {at.x - px(0.5F * kTraceWidth), at.y + radius + px(2), px(kTraceWidth),
                    px(kTraceHeight - 2)},
                   history_of(node, frame.viewer.playback.creature().readings().signals()),
                   forced ? colors().danger : colors().muted, px(1));
        const Color rim = forced         ? colors().danger
                          : i == chosen_ ? colors().accent
                          : lit          ? colors().text
                                         : colors().faint;
        const bool strong = forced || lit || i == chosen_;
        draw_shape(list, node.kind, at, radius,
                   {value_color(value), rim, strong ? px(2.5F) : px(1)});
        if (!ImGui::IsItemHovered()) continue;
        if (node.part >= 0) out.ask(ShowHighlight{{.part = node.part}});
        tooltip(words_for(node, value) + "\nClick for its history" +
                (node.kind == BrainNodeKind::kNeuron ? " and to force it." : "."));
    }
}

bool BrainTab::is_forced(const FrameContext& frame, const BrainNode& node) const {
    return node.kind == BrainNodeKind::kNeuron &&
           frame.viewer.playback.creature().replay().forced().count(neuron_of(node)) == 1;
}

std::size_t BrainTab::neuron_of(const BrainNode& node) const {
    return node.index - phenotype_->network.neuron_slot(0);
}

void BrainTab::draw_history(const FrameContext& frame) const {
    const BrainNode& node = graph_.nodes[chosen_];
    const double value = value_of(node, frame.viewer.playback.trial().creature().brain());
    caption(fmt::format("{}, the last 3 s; now {}", node.label, pretty_number(value)));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect area = {at.x, at.y, ImGui::GetContentRegionAvail().x, px(52)};
    draw_trace(*ImGui::GetWindowDrawList(), area,
               history_of(node, frame.viewer.playback.creature().readings().signals()),
               colors().accent, px(1.5F));
    ImGui::Dummy({area.width, area.height});
}

// Draws a switch and a slider that force the value of the chosen neuron.
void BrainTab::draw_force(const FrameContext& frame, Requests& out) {
    const BrainNode& node = graph_.nodes[chosen_];
    if (node.kind != BrainNodeKind::kNeuron) {
        muted_text("Choose a neuron, a round node, to force its value.");
        return;
    }
    const std::size_t neuron = neuron_of(node);
    const auto present = frame.viewer.playback.creature().replay().forced().find(neuron);
    bool forced = present != frame.viewer.playback.creature().replay().forced().end();
    double value =
        forced ? present->second : value_of(node, frame.viewer.playback.trial().creature().brain());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Force");
    ImGui::SameLine();
    if (toggle_switch("force neuron", forced)) {
        if (forced) {
            out.ask(ForceNeuron{neuron, value});
        } else {
            out.ask(ReleaseNeuron{neuron});
        }
    }
    tooltip(
        "The neuron outputs this value, whatever it computes. The run counts as disturbed "
        "until you restart it.");
    ImGui::SameLine();
    const float width = ImGui::GetContentRegionAvail().x;
    if (value_slider(value, {.range = {-kForceRange, kForceRange},
                             .width = width,
                             .allowed = SliderRange{-kMostForce, kMostForce}}))
        out.ask(ForceNeuron{neuron, value});
    note_place("forced value");
    tooltip(
        "The output of the neuron. Moving it forces the neuron; Ctrl+click to type, within ±10.");
}

}  // namespace cambrian
