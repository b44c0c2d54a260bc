#include "studio/panels/inspector/genotype_tab.h"

#include "core/text/pretty_text.h"
#include "pictures/scene/scene_builder.h"
#include "studio/frame/change_view.h"
#include "studio/panels/inspector/gene_table.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace cambrian {
namespace {

constexpr float kGeneRowHeight = 72.0F;
constexpr float kLeastRowHeight = 54.0F;
constexpr float kGraphShare = 0.45F;  // largest share of the tab's height
constexpr std::size_t kGenesInRow = 4;

ImVec2 half_size(const NodeGene& node) {
    constexpr float units_a_metre = 60.0F;
    const float length = std::clamp(static_cast<float>(node.length) * units_a_metre, 26.0F, 76.0F);
    const float width = std::clamp(static_cast<float>(node.width) * units_a_metre, 22.0F, 42.0F);
    return {0.5F * px(length), 0.5F * px(width)};
}

// Draws a loop beside a node, for an edge to itself.
void draw_loop(ImDrawList& list, const ImVec2& at, const ImVec2& half, const Color& color,
               int times) {
    const ImVec2 center = {at.x + half.x + px(7), at.y};
    list.AddCircle(center, px(9), paint(color), 20, px(1.5F));
    if (times < 2) return;
    const std::string text = fmt::format("×{}", times);
    list.AddText(ui().fonts.small, 13.0F * ui().scale, {center.x + px(12), at.y - px(8)},
                 paint(colors().muted), text.c_str());
}

// Draws a curve with an arrowhead at its target.
void draw_arrow(ImDrawList& list, const ImVec2& from, const ImVec2& to, const Color& color) {
    const float bend = 0.4F * std::fabs(to.y - from.y) + px(10);
    const float down = to.y >= from.y ? 1.0F : -1.0F;
    list.AddBezierCubic(from, {from.x, from.y + down * bend}, {to.x, to.y - down * bend}, to,
                        paint(color), px(1.5F), 18);
    list.AddTriangleFilled({to.x - px(4), to.y - down * px(8)}, {to.x + px(4), to.y - down * px(8)},
                           to, paint(color));
}

Color edge_color(const EdgeGene& edge) {
    if (edge.terminal_only) return colors().plot_median;
    if (edge.reflect) return colors().plot_best;
    return colors().muted;
}

// Returns whether two genomes have the same graph, so that a node's index has the same meaning in
// both.
bool same_graph(const Genome& a, const Genome& b) {
    const auto same_targets = [](const NodeGene& one, const NodeGene& other) {
        return std::equal(
            one.edges.begin(), one.edges.end(), other.edges.begin(), other.edges.end(),
            [](const EdgeGene& x, const EdgeGene& y) { return x.target == y.target; });
    };
    return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_targets);
}

// Returns whether a gene or a part that grew from it is highlighted. The highlighted part may be
// one of a larger creature that was on display before.
bool lights(const Highlight& highlight, std::size_t gene, const std::vector<BodyPart>& parts) {
    if (highlight.node == static_cast<int>(gene)) return true;
    const auto part = static_cast<std::size_t>(std::max(0, highlight.part));
    return highlight.part >= 0 && part < parts.size() && parts[part].node == gene;
}

// Keeps the creature on display while its genes are edited.
void stop_following(const FrameContext& frame, Requests& out) {
    if (!frame.view.newest_champion) return;
    change_view(frame, out, [](ViewState& view) { view.newest_champion = false; });
}

}  // namespace

std::vector<std::size_t> steps_from_root(const Genome& genome) {
    constexpr auto unreached = static_cast<std::size_t>(-1);
    std::vector<std::size_t> steps(genome.nodes.size(), unreached);
    std::deque<std::size_t> next = {0};
    steps[0] = 0;
    std::size_t deepest = 0;
    while (!next.empty()) {
        const std::size_t node = next.front();
        next.pop_front();
        deepest = std::max(deepest, steps[node]);
        for (const EdgeGene& edge : genome.nodes[node].edges) {
            if (steps[edge.target] != unreached) continue;
            steps[edge.target] = steps[node] + 1;
            next.push_back(edge.target);
        }
    }
    std::replace(steps.begin(), steps.end(), unreached, deepest + 1);
    return steps;
}

void GenotypeTab::rebuild(const GenomePtr& genome) {
    if (genome_ == nullptr || !same_graph(*genome_, *genome)) {
        chosen_ = 0;
        lit_ = false;
    }
    genome_ = genome;
    std::vector<GraphEdge> edges;
    for (std::size_t i = 0; i < genome->nodes.size(); ++i) {
        for (const EdgeGene& edge : genome->nodes[i].edges)
            edges.push_back({i, edge.target});
    }
    points_ = place_in_rows(steps_from_root(*genome), edges, kGenesInRow);
    std::vector<float> levels;
    for (const GraphPoint& point : points_)
        levels.push_back(point.y);
    std::sort(levels.begin(), levels.end());
    row_count_ =
        static_cast<std::size_t>(std::unique(levels.begin(), levels.end()) - levels.begin());
}

ImVec2 GenotypeTab::point_of(std::size_t node) const {
    return {area_.x + points_[node].x * area_.width, area_.y + points_[node].y * area_.height};
}

void GenotypeTab::draw(const FrameContext& frame, Requests& out) {
    if (genome_ != frame.viewer.playback.exhibit().genome())
        rebuild(frame.viewer.playback.exhibit().genome());
    muted_text(
        "Arrows lead to the parts that grow. Loops repeat; orange mirrors; blue ends a chain.");
    const auto rows = static_cast<float>(row_count_);
    const float most = kGraphShare * ImGui::GetContentRegionAvail().y;
    const float wanted = std::clamp(most, rows * px(kLeastRowHeight), rows * px(kGeneRowHeight));
    ImGui::BeginChild("graph", {0, std::max(px(kGeneRowHeight), std::min(wanted, most))}, false,
                      ImGuiWindowFlags_NoBackground);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    area_ = {at.x, at.y, ImGui::GetContentRegionAvail().x - px(10), wanted};
    draw_edges();
    draw_nodes(frame, out);
    ImGui::SetCursorScreenPos({at.x, at.y + wanted});
    ImGui::EndChild();
    if (lit_) out.ask(ShowHighlight{{.chosen = static_cast<int>(chosen_)}});
    draw_heading(frame, out);
    ImGui::BeginChild("genes", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    draw_genes(frame, out);
    ImGui::EndChild();
}

void GenotypeTab::draw_edges() const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < genome_->nodes.size(); ++i) {
        const NodeGene& node = genome_->nodes[i];
        const ImVec2 half = half_size(node);
        const ImVec2 from = point_of(i);
        for (const EdgeGene& edge : node.edges) {
            const Color color = edge_color(edge);
            if (edge.target == i) {
                draw_loop(list, from, half, color, node.recursion_limit);
                continue;
            }
            const ImVec2 to = point_of(edge.target);
            const float target_half = half_size(genome_->nodes[edge.target]).y;
            const float down = to.y >= from.y ? 1.0F : -1.0F;
            draw_arrow(list, {from.x, from.y + down * half.y},
                       {to.x, to.y - down * (target_half + px(2))}, color);
        }
    }
}

void GenotypeTab::draw_nodes(const FrameContext& frame, Requests& out) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto& parts = frame.viewer.playback.creature().phenotype().parts;
    for (std::size_t i = 0; i < genome_->nodes.size(); ++i) {
        const ImVec2 half = half_size(genome_->nodes[i]);
        const ImVec2 at = point_of(i);
        const ImVec2 low = {at.x - half.x, at.y - half.y};
        const ImVec2 high = {at.x + half.x, at.y + half.y};
        ImGui::SetCursorScreenPos(low);
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::InvisibleButton("gene", {2 * half.x, 2 * half.y})) {
            lit_ = chosen_ != i || !lit_;
            chosen_ = i;
        }
        ImGui::PopID();
        note_place(fmt::format("gene {}", i));
        if (ImGui::IsItemHovered()) out.ask(ShowHighlight{{.node = static_cast<int>(i)}});
        tooltip("Click to edit its genes and keep its parts lit; click again to stop.");
        BodyPart part;
        part.node = static_cast<std::uint8_t>(i);
        const bool grown = std::any_of(parts.begin(), parts.end(),
                                       [i](const BodyPart& each) { return each.node == i; });
        const bool lit = lights(frame.viewer.highlight, i, parts);
        const Color fill = part_color(part, genome_->hue);
        list.AddRectFilled(low, high, paint(with_alpha(fill, grown ? 1.0F : 0.25F)), px(6));
        const bool strong = lit || i == chosen_;
        const Color rim = i == chosen_ ? colors().accent : colors().text;
        list.AddRect(low, high, paint(strong ? rim : mix(fill, colors().window, 0.4F)), px(6),
                     ImDrawFlags_None, strong ? px(2.5F) : px(1));
        const std::string label = std::to_string(i);
        const ImVec2 size = ImGui::CalcTextSize(label.c_str());
        list.AddText({at.x - 0.5F * size.x, at.y - 0.5F * size.y}, paint(color_of(0x0B0E12)),
                     label.c_str());
    }
}

// Draws the name of the gene shown below, and the buttons for an edited creature.
void GenotypeTab::draw_heading(const FrameContext& frame, Requests& out) const {
    panel_title(chosen_ == 0 ? "Gene 0, the root" : fmt::format("Gene {}", chosen_));
    const auto& parts = frame.viewer.playback.creature().phenotype().parts;
    const auto grown = std::count_if(parts.begin(), parts.end(),
                                     [this](const BodyPart& part) { return part.node == chosen_; });
    ImGui::SameLine(0, px(10));
    caption(grown == 1 ? "1 part" : fmt::format("{} parts", grown));
    const GeneEditor* genes = frame.viewer.genes;
    const bool can_undo = genes != nullptr && genes->can_undo();
    const bool can_redo = genes != nullptr && genes->can_redo();
    if (!can_undo && !can_redo && frame.viewer.playback.exhibit().individual().method != "edited")
        return;
    const auto button = [](const char* label, const char* help, bool enabled) {
        return push_button(label, {.height = px(26), .enabled = enabled, .tooltip = help});
    };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(4)));
    if (button("Undo", "Undo the last edit of a gene (Ctrl+Z)", can_undo)) out.ask(UndoEdit{});
    ImGui::SameLine();
    if (button("Redo", "Repeat the edit that was undone (Ctrl+Shift+Z)", can_redo))
        out.ask(RedoEdit{});
    ImGui::SameLine();
    if (button("Save", "Keep the edited creature in a file (Ctrl+S)", true))
        out.ask(OpenFilePanel{FileTask::kSaveCreature});
    ImGui::SameLine();
    if (button("New run", "Begin a new run with this creature as its founder", true))
        out.ask(StartFromShown{});
    ImGui::PopStyleVar();
}

void GenotypeTab::draw_genes(const FrameContext& frame, Requests& out) const {
    Genome genome = *genome_;
    GeneEdit edit = gene_table(genome, chosen_, frame.kinds.creature);
    if (edit.change) {
        out.ask(
            EditGenes{std::make_shared<const Genome>(std::move(genome)), std::move(*edit.change)});
    }
    if (edit.begun) stop_following(frame, out);
    if (edit.finished) out.ask(FinishGeneEdit{});
}

}  // namespace cambrian
