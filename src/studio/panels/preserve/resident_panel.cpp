#include "studio/panels/preserve/resident_panel.h"

#include "core/text/pretty_text.h"
#include "genome/creature_name.h"
#include "pictures/preserve/world_scene.h"
#include "preserve/life/diet.h"
#include "preserve/world_time.h"
#include "studio/frame/help_mark.h"
#include "studio/panels/inspector/network_drawing.h"
#include "studio/preserve/notables.h"
#include "studio/preserve/world_words.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostChildren = 12;  // that are listed
constexpr std::size_t kNodesAcross = 6;    // of a brain
constexpr float kLiveRowHeight = 30.0F;
constexpr float kNodeRadius = 7.0F;

std::string joules_words(double energy) {
    return measured(energy, "J");
}

// Draws a button that picks a creature, if it is alive.
void creature_button(const PreservePicture& picture, std::uint64_t number, Requests& out) {
    const std::string label = fmt::format("{}", number);
    const bool alive = picture.find(number) != nullptr;
    const float width = ImGui::CalcTextSize(label.c_str()).x + px(16);
    const float right = ImGui::GetItemRectMax().x + px(4) + width;
    const float edge = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (right <= edge) ImGui::SameLine(0, px(4));
    if (push_button(label, {.look = alive ? ButtonLook::kPlain : ButtonLook::kGhost,
                            .width = width,
                            .height = px(24),
                            .enabled = alive,
                            .tooltip = alive ? "Pick this creature (U for a parent, C for a child)"
                                             : "It is not alive"}))
        out.ask(PickResident{number});
}

void draw_family(const PreservePicture& picture, const Life& life, Requests& out) {
    section("Family");
    {
        const WithTextColor muted(colors().muted);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("Parents");
    }
    bool any = false;
    for (const std::uint64_t parent : life.parents) {
        if (parent != 0) creature_button(picture, parent, out);
        any = any || parent != 0;
    }
    if (!any) {
        ImGui::SameLine();
        ImGui::TextUnformatted(life.method == "added" ? "none, added by hand" : "none, a founder");
    }
    fact("Children", fmt::format("{}", life.children));
    std::size_t listed = 0;
    for (const ResidentPicture& each : picture.residents) {
        const auto& parents = each.life.parents;
        if (parents[0] != life.number && parents[1] != life.number) continue;
        if (listed == 0) {
            const WithTextColor muted(colors().muted);
            ImGui::AlignTextToFramePadding();
            ImGui::TextUnformatted("alive");
        }
        if (++listed > kMostChildren) break;
        creature_button(picture, each.life.number, out);
    }
}

void draw_store(const ResidentPicture& picked) {
    fact("Energy in store", joules_words(picked.store));
    progress_bar(static_cast<float>(picked.store / std::max(picked.birth_need, 1e-9)), 0.0F, px(6));
    tooltip("A full bar is enough to bear a child of its size.");
}

void draw_energy(const ResidentPicture& picked) {
    section("Energy");
    const Life& life = picked.life;
    fact("Bound in its body", joules_words(picked.body));
    fact("Gained from plants", joules_words(joules(life.eaten_plants)));
    fact("Gained from flesh", joules_words(joules(life.eaten_flesh)));
    fact("Gained by bites", joules_words(joules(life.bitten)));
    fact("Lost to bites", joules_words(joules(life.lost)));
}

void draw_body(const Life& life) {
    section("Body");
    fact("Mass", measured(life.mass, "kg"));
    fact("Parts", fmt::format("{}", life.parts));
    fact("Connected neurons", fmt::format("{}", life.neurons));
    fact("Diet", fmt::format("{:.2f}", life.diet));
    tooltip("0 means plants, 1 means flesh and bites.");
    fact("Digests of plants", fmt::format("{:.0f} %", 100.0 * share_of_plants(life.diet)));
    fact("Digests of flesh", fmt::format("{:.0f} %", 100.0 * share_of_flesh(life.diet)));
}

void draw_buttons(const PreserveView& preserve, bool alive, Requests& out) {
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - px(6));
    const auto button = [&](const char* label, const char* hint, bool chosen, bool enabled,
                            float width) {
        return push_button(label, {.look = chosen ? ButtonLook::kSelected : ButtonLook::kPlain,
                                   .width = width,
                                   .enabled = enabled,
                                   .tooltip = hint});
    };
    const bool pinned = preserve.pins.creatures.contains(preserve.picked->life.number);
    if (button("Follow", "The camera follows it (F)", preserve.follow, alive, half))
        out.ask(FollowPicked{});
    ImGui::SameLine(0, px(6));
    if (button(pinned ? "Unpin" : "Pin", "Marks it in the world (P)", pinned, alive, half))
        out.ask(PinPicked{});
    if (button("Show alone", "Displays it in the viewer, with its brain and its genes (V)", false,
               true, half))
        out.ask(ShowPicked{});
    ImGui::SameLine(0, px(6));
    if (button("Save…", "Saves it as a creature file or a card (S)", false, true, half))
        out.ask(SaveResident{});
    if (button("Remove", "Ends its life; its energy becomes flesh (Delete)", false, alive, half))
        out.ask(RemovePicked{});
    ImGui::SameLine(0, px(6));
    const bool inherited = preserve.pins.inherited;
    if (button("Pin children", "Children of pinned creatures are pinned at birth (Shift+P)",
               inherited, pinned || inherited, half))
        out.ask(InheritPins{});
}

void draw_notables(const PreservePicture& picture, Requests& out) {
    muted_text("Click a creature to see its life, or press Tab for the next one.");
    if (picture.residents.empty()) return;
    section("Outstanding now");
    for (const Notable& notable : notables_in(picture)) {
        const bool is_time = std::string_view(notable.unit) == "s";
        fact(notable.label,
             is_time ? pretty_time(notable.number) : with_unit(notable.number, notable.unit));
        ImGui::PushID(notable.label);
        if (push_button(called(picture, notable.creature),
                        {.width = ImGui::GetContentRegionAvail().x,
                         .height = px(26),
                         .tooltip = "Pick it (O goes through them)"}))
            out.ask(PickResident{notable.creature});
        ImGui::PopID();
    }
}

// Draws a network with the present values of its signals.
void draw_live(const BrainGraph& graph, const LiveBrain& live) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect area = {at.x, at.y, ImGui::GetContentRegionAvail().x,
                       static_cast<float>(graph.row_count) * px(kLiveRowHeight)};
    ImGui::Dummy({area.width, area.height});
    note_place("live brain");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_links(list, graph, area);
    const float radius = px(kNodeRadius);
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        const BrainNode& node = graph.nodes[i];
        const double value =
            (node.kind == BrainNodeKind::kEffector ? live.outputs : live.slots)[node.index];
        const ImVec2 place = point_of(graph, area, i);
        draw_shape(list, node.kind, place, radius, {value_color(value), colors().faint, px(1)});
        if (ImGui::IsWindowHovered() &&
            ImGui::IsMouseHoveringRect({place.x - radius, place.y - radius},
                                       {place.x + radius, place.y + radius}))
            ImGui::SetTooltip("%s", words_for(node, value).c_str());
    }
}

}  // namespace

// Draws the picked creature's brain while it lives.
void ResidentPanel::draw_brain(const FrameContext& frame) {
    const ResidentPicture& picked = *frame.preserve->picked;
    const LiveBrain& live = frame.preserve->picture.brain;
    if (live.creature != picked.life.number) return;
    if (std::exchange(phenotype_, picked.phenotype) != picked.phenotype)
        graph_ = brain_graph(*phenotype_, frame.kinds.creature, kNodesAcross);
    section("Brain");
    draw_live(graph_, live);
}

void ResidentPanel::draw_picked(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    const ResidentPicture& picked = *preserve.picked;
    const bool alive = picked.life.died == 0;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, px(78)});
    draw_creature_tile(*ImGui::GetWindowDrawList(), {at.x, at.y, width, px(74)}, *picked.phenotype,
                       lineage_hue(picked.life.lineage), picked.life.lineage);
    {
        const WithTextColor color(alive ? colors().text : colors().danger);
        ImGui::TextUnformatted(capitalized(fate_words(picked.life)).c_str());
    }
    fact("Age", pretty_time(age_of(picked.life, preserve.picture.tick)));
    fact("Born at", world_time(picked.life.born));
    fact("Lineage", "of " + called(preserve.picture, picked.life.lineage));
    draw_store(picked);
    draw_buttons(preserve, alive, out);
    draw_brain(frame);
    draw_energy(picked);
    draw_family(preserve.picture, picked.life, out);
    draw_body(picked.life);
}

void ResidentPanel::draw(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    place_title(preserve.picked == nullptr
                    ? "Creature"
                    : fmt::format("{} {}", creature_name(*preserve.picked->life.genome),
                                  preserve.picked->life.number),
                "preserve", out);
    ImGui::BeginChild("life", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    if (preserve.picked == nullptr) {
        draw_notables(preserve.picture, out);
    } else {
        draw_picked(frame, out);
    }
    ImGui::EndChild();
}

}  // namespace cambrian
