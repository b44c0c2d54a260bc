#include "studio/panels/inspector/gene_table.h"

#include "core/text/pretty_text.h"
#include "genome/gene_fields.h"
#include "genome/words.h"
#include "math/angle.h"
#include "studio/widgets/value_slider.h"
#include "studio/widgets/widgets.h"

#include <array>
#include <string_view>
#include <utility>

namespace cambrian {
namespace {

constexpr float kGeneLabelShare = 0.46F;

// The unit in which a gene is shown, and the factor from the gene's own unit to it.
struct ShownUnit {
    const char* unit;
    double factor;
};

ShownUnit shown_unit(std::string_view unit, bool slides) {
    if (unit == "rad") return slides ? ShownUnit{"x", 1.0} : ShownUnit{"deg", to_degrees(1.0)};
    return {unit == "m" ? "m" : "", 1.0};
}

std::string number_words(double value, const ShownUnit& unit) {
    return with_unit(value * unit.factor, unit.unit);
}

std::string pattern_of(const ShownUnit& unit) {
    const std::string pretty = pretty_unit(unit.unit);
    if (pretty == "°") return "%.0f°";
    return "%.2f" + (pretty.empty() || pretty == "×" ? pretty : " " + pretty);
}

std::string range_words(const FieldRule& rule, const ShownUnit& unit) {
    return "Allowed " + number_words(rule.low, unit) + " to " + number_words(rule.high, unit) +
           "; Ctrl+click to type.";
}

// Draws the rows and records which gene changed.
class GeneRows {
public:
    GeneRows(const Kinds& kinds, GeneEdit& edit) : kinds_(kinds), edit_(edit) {}

    template <class Gene>
    void field(const std::string& owner, Gene& gene, const GeneField<Gene>& field, bool slides) {
        number(owner + field.rule.name, capitalized(field.rule.name), gene.*field.value, field.rule,
               shown_unit(field.rule.unit, slides));
    }
    template <class Gene>
    void numbers(const std::string& owner, Gene& gene, std::span<const GeneField<Gene>> fields) {
        for (const GeneField<Gene>& each : fields)
            field(owner, gene, each, false);
    }

    void number(const std::string& place, const std::string& label, double& value,
                const FieldRule& rule, const ShownUnit& unit) {
        begin_row(place, label);
        const std::string before = number_words(value, unit);
        double shown = value * unit.factor;
        const SliderRange range = {rule.low * unit.factor, rule.high * unit.factor};
        if (value_slider(shown, {.range = range, .pattern = pattern_of(unit), .width = width_})) {
            value = shown / unit.factor;
            note(place, before, number_words(value, unit));
        }
        end_slider(place, range_words(rule, unit));
    }

    void whole(const std::string& place, const std::string& label, int& value, int low, int high) {
        begin_row(place, label);
        const std::string before = std::to_string(value);
        const SliderRange range = {static_cast<double>(low), static_cast<double>(high)};
        if (value_slider(value, {.range = range, .width = width_}))
            note(place, before, std::to_string(value));
        end_slider(place, "Allowed " + std::to_string(low) + " to " + std::to_string(high) +
                              "; Ctrl+click to type.");
    }

    void flag(const std::string& place, const std::string& label, bool& value, const char* help) {
        begin_row(place, label);
        if (toggle_switch("##value", value)) finish(place, value ? "no" : "yes", yes_no(value));
        note_place(place);
        tooltip(help);
        ImGui::PopID();
    }

    template <class Choice, class Labels>
    bool choice(const std::string& place, const std::string& label, Choice& value,
                const Labels& labels) {
        begin_row(place, label);
        const auto chosen = static_cast<std::size_t>(value);
        bool changed = false;
        if (begin_choice("##value", labels[chosen], width_)) {
            for (std::size_t i = 0; i < labels.size(); ++i) {
                if (ImGui::Selectable(labels[i].c_str(), i == chosen) && i != chosen) {
                    value = static_cast<Choice>(i);
                    finish(place, labels[chosen], labels[i]);
                    changed = true;
                }
                note_place(place + "=" + labels[i]);
            }
            ImGui::EndCombo();
        }
        note_place(place);
        ImGui::PopID();
        return changed;
    }

    void input(const std::string& place, InputGene& gene) {
        const std::string source = in_words(gene.source, kinds_.catalog);
        number(place, "From " + source, gene.weight, input_fields().front().rule, {"", 1.0});
    }

    void neurons(const std::string& owner, std::vector<NeuronGene>& neurons) {
        std::vector<std::string> labels;
        for (const FunctionEntry& function : kinds_.catalog.functions)
            labels.push_back(function.label);
        for (std::size_t i = 0; i < neurons.size(); ++i) {
            const std::string place = owner + "neuron " + std::to_string(i);
            NeuronGene& neuron = neurons[i];
            heading("Neuron " + std::to_string(i));
            if (choice(place + " function", "Function", neuron.function, labels)) {
                const int arity = kinds_.catalog.functions[neuron.function].arity;
                neuron.inputs.resize(static_cast<std::size_t>(arity), InputGene{{}, 0.0});
            }
            for (std::size_t k = 0; k < neuron.inputs.size(); ++k)
                input(place + " input " + std::to_string(k), neuron.inputs[k]);
        }
    }

    static void heading(const std::string& text) {
        ImGui::Dummy({0, px(3)});
        caption(text);
    }

private:
    static std::string yes_no(bool value) { return value ? "yes" : "no"; }

    void begin_row(const std::string& place, const std::string& label) {
        ImGui::PushID(place.c_str());
        const float full = ImGui::GetContentRegionAvail().x;
        const float label_width = std::floor(kGeneLabelShare * full);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = ImGui::GetFrameHeight();
        ImGui::Dummy({label_width, height});
        const std::string shown = fit_text(label, label_width - px(8));
        const float y = std::floor(at.y + 0.5F * (height - ImGui::GetFontSize()));
        ImGui::GetWindowDrawList()->AddText({at.x, y}, paint(colors().muted), shown.c_str());
        tooltip(label + "\nIn words of mutations: " + place);
        ImGui::SameLine(0.0F, 0.0F);
        width_ = full - label_width;
    }
    void end_slider(const std::string& place, const std::string& help) {
        if (ImGui::IsItemDeactivatedAfterEdit()) edit_.finished = true;
        note_place(place);
        tooltip(help);
        ImGui::PopID();
    }
    void note(const std::string& place, std::string from, std::string to) {
        edit_.change = GeneChange{place, std::move(from), std::move(to)};
    }
    void finish(const std::string& place, std::string from, std::string to) {
        note(place, std::move(from), std::move(to));
        edit_.finished = true;
    }

    const Kinds& kinds_;
    GeneEdit& edit_;
    float width_ = 0.0F;  // width of the controls, in pixels
};

template <class Entry>
std::vector<std::string> labels_of(const std::vector<Entry>& entries) {
    std::vector<std::string> labels;
    for (const Entry& entry : entries)
        labels.push_back(entry.label);
    return labels;
}

void draw_part(GeneRows& rows, NodeGene& node, std::size_t index, const Kinds& kinds) {
    const std::string owner = "part " + std::to_string(index) + " ";
    const bool slides = kinds.scene.joints[node.joint].motion == JointMotion::kSlide;
    if (index > 0)
        rows.choice(owner + "joint", "Joint", node.joint, labels_of(kinds.catalog.joints));
    for (const GeneField<NodeGene>& field : node_fields()) {
        const bool of_joint = std::string_view(field.rule.unit) == "rad";
        if (index > 0 || !of_joint) rows.field(owner, node, field, slides);
    }
    rows.whole(owner + "recursion limit", "Repeats at most", node.recursion_limit, 1,
               gene_range::kMaxRecursion);
    rows.flag(owner + "symmetric", "Mirror pairs", node.symmetric,
              "Parts that grow twice from one parent are mirror images.");
    static const std::array<std::string, 2> axes = {"Along", "Across"};
    rows.choice(owner + "mirror axis", "Mirror axis", node.mirror_axis, axes);
    if (index > 0) {
        GeneRows::heading("What drives its joint");
        if (kinds.effectors.size() > 1)
            rows.choice(owner + "effector kind", "How", node.effector_kind,
                        labels_of(kinds.catalog.effectors));
        rows.input(owner + "effector", node.effector);
    }
}

void draw_edges(GeneRows& rows, NodeGene& node, std::size_t index) {
    for (std::size_t i = 0; i < node.edges.size(); ++i) {
        EdgeGene& edge = node.edges[i];
        const std::string owner =
            "part " + std::to_string(index) + " edge " + std::to_string(i) + " ";
        GeneRows::heading("Grows gene " + std::to_string(edge.target));
        rows.numbers(owner, edge, edge_fields());
        rows.flag(owner + "reflect", "Mirrored", edge.reflect,
                  "What grows here is a mirror image.");
        rows.flag(owner + "terminal only", "Only at the end", edge.terminal_only,
                  "Grows only where the repetition of its parent has ended.");
    }
}

}  // namespace

GeneEdit gene_table(Genome& genome, std::size_t node, const Kinds& kinds) {
    GeneEdit edit;
    GeneRows rows(kinds, edit);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(3)));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(8), px(3)));
    if (node == 0) rows.numbers("", genome, genome_fields());
    draw_part(rows, genome.nodes[node], node, kinds);
    draw_edges(rows, genome.nodes[node], node);
    rows.neurons("part " + std::to_string(node) + " ", genome.nodes[node].neurons);
    if (node == 0 && !genome.brain.empty()) {
        section("Central brain");
        rows.neurons("brain ", genome.brain);
    }
    ImGui::PopStyleVar(2);
    return edit;
}

}  // namespace cambrian
