#include "studio/panels/inspector/gene_table.h"

#include "core/text/pretty_text.h"
#include "genome/gene_fields.h"
#include "genome/source_rules.h"
#include "genome/words.h"
#include "math/angle.h"
#include "studio/widgets/value_slider.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <span>
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
    return fmt::format("{}{}Allowed {} to {}; Ctrl+click to type.", rule.help,
                       *rule.help == '\0' ? "" : "\n", number_words(rule.low, unit),
                       number_words(rule.high, unit));
}

// Returns a field's name, or what tells more to who has not read of genes.
std::string label_of(const FieldRule& rule) {
    constexpr std::array<std::pair<std::string_view, const char*>, 5> plainer = {
        {{"recursion limit", "Repeats at most"},
         {"symmetric", "Mirror pairs"},
         {"reflect", "Mirrored"},
         {"reflect depth", "Front to back"},
         {"terminal only", "Only at the end"}}};
    const auto found = std::find_if(plainer.begin(), plainer.end(),
                                    [&](const auto& each) { return each.first == rule.name; });
    return found != plainer.end() ? found->second : capitalized(rule.name);
}

// Draws the rows and records which gene changed.
class GeneRows {
public:
    GeneRows(const Kinds& kinds, GeneEdit& edit) : kinds_(kinds), edit_(edit) {}

    // Draws the numbers, flags and choices of a gene's body, unless `left_out` tells to leave one
    // out.
    template <class Gene, class LeftOut>
    void fields(const std::string& owner, Gene& gene, bool slides, LeftOut left_out) {
        visit_fields<Gene>([&](const auto& field) {
            const FieldRule& rule = field.rule;
            if (!field.is_of(kinds_.catalog.dimensions) || left_out(rule)) return;
            auto& value = gene.*field.value;
            using Value = std::remove_reference_t<decltype(value)>;
            const std::string place = owner + rule.name;
            if constexpr (std::is_same_v<Value, double>)
                number(place, label_of(rule), value, rule, shown_unit(rule.unit, slides));
            else if constexpr (std::is_same_v<Value, int>)
                whole(place, label_of(rule), value, rule);
            else if constexpr (std::is_same_v<Value, bool>)
                flag(place, label_of(rule), value, rule.help);
            else if constexpr (std::is_same_v<Value, MirrorAxis>)
                choice(place, label_of(rule), value, axes());
        });
    }
    template <class Gene>
    void fields(const std::string& owner, Gene& gene, bool slides = false) {
        fields(owner, gene, slides, [](const FieldRule&) { return false; });
    }

    void number(const std::string& place, const std::string& label, double& value,
                const FieldRule& rule, const ShownUnit& unit) {
        begin_row(place, label);
        const std::string before = number_words(value, unit);
        double shown = value * unit.factor;
        const SliderRange range = {rule.low * unit.factor, rule.high * unit.factor};
        if (value_slider(
                shown,
                {.range = range, .pattern = pattern_of(unit), .width = width_, .allowed = range})) {
            value = shown / unit.factor;
            note(place, before, number_words(value, unit));
        }
        end_slider(place, range_words(rule, unit));
    }

    void whole(const std::string& place, const std::string& label, int& value,
               const FieldRule& rule) {
        begin_row(place, label);
        const std::string before = std::to_string(value);
        const SliderRange range = {rule.low, rule.high};
        if (value_slider(value, {.range = range, .width = width_, .allowed = range}))
            note(place, before, std::to_string(value));
        end_slider(place, range_words(rule, {"", 1.0}));
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
            edit_.begun = true;
            for (std::size_t i = 0; i < labels.size(); ++i) {
                if (choice_line(labels[i], i == chosen) && i != chosen) {
                    value = static_cast<Choice>(i);
                    finish(place, labels[chosen], labels[i]);
                    changed = true;
                }
                note_place(fmt::format("{}={}", place, labels[i]));
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

    void parameter(const std::string& place, double& value, const FieldRule& rule) {
        const std::string label = capitalized(rule.name);
        if (!rule.whole) return number(place, label, value, rule, shown_unit(rule.unit, false));
        int whole_value = static_cast<int>(value);
        whole(place, label, whole_value, rule);
        value = whole_value;
    }

    void source(const std::string& place, SourceRef& source, std::vector<SourceRef> choices) {
        if (std::find(choices.begin(), choices.end(), source) == choices.end())
            choices.push_back(source);
        std::vector<std::string> labels;
        for (const SourceRef& each : choices)
            labels.push_back(capitalized(in_words(each, kinds_.catalog)));
        auto chosen = static_cast<std::size_t>(std::find(choices.begin(), choices.end(), source) -
                                               choices.begin());
        if (choice(place, "Follows", chosen, labels)) source = choices[chosen];
    }

    // A button for a change that is complete at once; returns true when pressed.
    bool button(const std::string& label, const std::string& place, std::string from,
                std::string to, const char* help) {
        ImGui::PushID(place.c_str());
        const bool pressed = push_button(label, {.height = px(26), .tooltip = help});
        ImGui::PopID();
        if (pressed) finish(place, std::move(from), std::move(to));
        return pressed;
    }

    void neurons(const std::string& owner, std::vector<NeuronGene>& neurons) {
        std::vector<std::string> labels;
        for (const FunctionEntry& function : kinds_.catalog.functions)
            labels.push_back(function.label);
        for (std::size_t i = 0; i < neurons.size(); ++i) {
            const std::string place = fmt::format("{}neuron {}", owner, i);
            NeuronGene& neuron = neurons[i];
            heading(fmt::format("Neuron {}", i));
            if (choice(place + " function", "Function", neuron.function, labels)) {
                const int arity = kinds_.catalog.functions[neuron.function].arity;
                neuron.inputs.resize(static_cast<std::size_t>(arity), InputGene{{}, 0.0});
            }
            for (std::size_t k = 0; k < neuron.inputs.size(); ++k)
                input(fmt::format("{} input {}", place, k), neuron.inputs[k]);
        }
    }

    static void heading(const std::string& text) {
        ImGui::Dummy({0, px(3)});
        caption(text);
    }

private:
    static std::string yes_no(bool value) { return value ? "yes" : "no"; }

    std::vector<std::string> axes() const {
        std::vector<std::string> labels = {"Along", "Across", "Depth"};
        labels.resize(static_cast<std::size_t>(last_mirror_axis(kinds_.catalog.dimensions)) + 1);
        return labels;
    }

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
        tooltip(fmt::format("{}\nIn words of mutations: {}", label, place));
        ImGui::SameLine(0.0F, 0.0F);
        width_ = full - label_width;
    }
    void end_slider(const std::string& place, const std::string& help) {
        if (ImGui::IsItemActivated()) edit_.begun = true;
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

void draw_joint(GeneRows& rows, NodeGene& node, const std::string& owner, const Kinds& kinds) {
    const std::vector<JointChoice>& joints = kinds.catalog.joints;
    if (!rows.choice(owner + "joint", "Joint", node.joint, labels_of(joints))) return;
    const int degrees = std::max(joints[node.joint].degrees_of_freedom, 1);
    node.further.resize(static_cast<std::size_t>(degrees - 1));
}

void draw_part(GeneRows& rows, NodeGene& node, std::size_t index, const Kinds& kinds) {
    const std::string owner = fmt::format("part {} ", index);
    const JointMotion motion = kinds.scene.joints[node.joint].motion;
    const bool slides = motion == JointMotion::kSlide;
    if (index > 0) draw_joint(rows, node, owner, kinds);
    rows.fields(owner, node, slides, [&](const FieldRule& rule) {
        return index == 0 && std::string_view(rule.unit) == "rad";
    });
    if (index == 0) return;
    GeneRows::heading("Effector of its joint");
    if (kinds.effectors.size() > 1)
        rows.choice(owner + "effector kind", "Kind", node.effector_kind,
                    labels_of(kinds.catalog.effectors));
    rows.input(owner + "effector", node.effector);
    for (std::size_t i = 0; i < node.further.size(); ++i) {
        GeneRows::heading(fmt::format("Degree of freedom {}", i + 2));
        // The cone of a ball has the limits of the first.
        const bool no_limits = i == 0 && motion == JointMotion::kBall;
        rows.fields(fmt::format("{}degree {} ", owner, i + 2), node.further[i], false,
                    [no_limits](const FieldRule&) { return no_limits; });
        rows.input(fmt::format("{}effector {}", owner, i + 2), node.further[i].effector);
    }
}

// The sources that can be chosen for an organ: a constant, the part's neurons and senses, and the
// central neurons.
std::vector<SourceRef> organ_sources(const Genome& genome, const NodeGene& node,
                                     const KindCatalog& catalog) {
    const auto numbered = [](SourceKind kind, std::size_t index) {
        return SourceRef{kind, static_cast<std::uint8_t>(index)};
    };
    std::vector<SourceRef> sources = {SourceRef{}};
    for (std::size_t i = 0; i < node.neurons.size(); ++i)
        sources.push_back(numbered(SourceKind::kLocalNeuron, i));
    for (std::size_t i = 0; i < genome.brain.size(); ++i)
        sources.push_back(numbered(SourceKind::kBrainNeuron, i));
    for (std::size_t i = 0; i < catalog.channels.size(); ++i)
        sources.push_back(numbered(SourceKind::kLocalSensor, i));
    return sources;
}

// Returns an organ with the usual parameters that hears the part's first neuron, if it has one.
OrganGene new_organ(std::size_t kind, const NodeGene& node, const KindCatalog& catalog) {
    OrganGene organ;
    organ.kind = static_cast<std::uint8_t>(kind);
    if (!node.neurons.empty()) organ.input.source = own_neuron(SourceScope::kPart, 0);
    const std::vector<FieldRule>& rules = catalog.organs[kind].parameters;
    for (std::size_t i = 0; i < rules.size(); ++i)
        organ.parameters[i] = rules[i].fallback;
    return organ;
}

// Draws an organ; returns true if it is to be removed.
bool draw_organ(GeneRows& rows, OrganGene& organ, const std::string& place,
                const std::vector<SourceRef>& sources, const Kinds& kinds) {
    const OrganKind& kind = kinds.organs[organ.kind];
    const std::vector<FieldRule>& rules = kinds.catalog.organs[organ.kind].parameters;
    GeneRows::heading(kind.label);
    muted_text(kind.words(std::span(organ.parameters.data(), rules.size())));
    rows.source(place + " source", organ.input.source, sources);
    rows.number(place + " weight", "Weight", organ.input.weight, input_fields().front().rule,
                {"", 1.0});
    for (std::size_t i = 0; i < rules.size(); ++i)
        rows.parameter(place + " " + rules[i].name, organ.parameters[i], rules[i]);
    return rows.button("Remove", place, kinds.organs[organ.kind].id, "removed",
                       "Remove this organ from the gene.");
}

// Returns whether a button fits on the line of the last item.
bool has_room_for_button(const std::string& label) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2.0F * style.FramePadding.x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    return ImGui::GetItemRectMax().x + style.ItemSpacing.x + width <= right;
}

bool may_have_another(const NodeGene& node, std::size_t kind, const KindCatalog& catalog) {
    return !catalog.organs[kind].single ||
           std::none_of(node.organs.begin(), node.organs.end(),
                        [&](const OrganGene& organ) { return organ.kind == kind; });
}

void draw_organs(GeneRows& rows, Genome& genome, std::size_t index, const Kinds& kinds) {
    NodeGene& node = genome.nodes[index];
    const std::string owner = fmt::format("part {}", index);
    const std::vector<SourceRef> sources = organ_sources(genome, node, kinds.catalog);
    std::optional<std::size_t> removed;
    for (std::size_t i = 0; i < node.organs.size(); ++i) {
        const std::string place = fmt::format("{} organ {}", owner, i);
        if (draw_organ(rows, node.organs[i], place, sources, kinds)) removed = i;
    }
    if (removed) node.organs.erase(node.organs.begin() + static_cast<std::ptrdiff_t>(*removed));
    if (node.organs.size() >= gene_range::kMaxOrgans || kinds.organs.size() == 0) return;
    GeneRows::heading("New organ");
    bool is_first = true;
    for (std::size_t kind = 0; kind < kinds.organs.size(); ++kind) {
        if (!may_have_another(node, kind, kinds.catalog)) continue;
        const std::string place = fmt::format("{} organ {}", owner, node.organs.size());
        const OrganKind& added = kinds.organs[kind];
        const OrganGene organ = new_organ(kind, node, kinds.catalog);
        const std::string help =
            added.words(std::span(organ.parameters.data(), added.parameters.size()));
        const std::string label = "Add " + added.id;
        if (!std::exchange(is_first, false) && has_room_for_button(label)) ImGui::SameLine();
        if (!rows.button(label, place, "", "new organ " + added.id, help.c_str())) continue;
        node.organs.push_back(organ);
        return;
    }
}

void draw_edges(GeneRows& rows, NodeGene& node, std::size_t index) {
    for (std::size_t i = 0; i < node.edges.size(); ++i) {
        EdgeGene& edge = node.edges[i];
        const std::string owner = fmt::format("part {} edge {} ", index, i);
        GeneRows::heading(fmt::format("Grows gene {}", edge.target));
        rows.fields(owner, edge);
    }
}

}  // namespace

GeneEdit gene_table(Genome& genome, std::size_t node, const Kinds& kinds) {
    GeneEdit edit;
    GeneRows rows(kinds, edit);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(3)));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(8), px(3)));
    if (node == 0) rows.fields("", genome);
    draw_part(rows, genome.nodes[node], node, kinds);
    draw_organs(rows, genome, node, kinds);
    draw_edges(rows, genome.nodes[node], node);
    rows.neurons(fmt::format("part {} ", node), genome.nodes[node].neurons);
    if (node == 0 && !genome.brain.empty()) {
        section("Central brain");
        rows.neurons("brain ", genome.brain);
    }
    ImGui::PopStyleVar(2);
    return edit;
}

}  // namespace cambrian
