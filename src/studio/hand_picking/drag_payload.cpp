#include "studio/hand_picking/drag_payload.h"

#include <imgui.h>

#include <cstring>

namespace cambrian {
namespace {

constexpr const char* kCell = "grid cell";
constexpr const char* kPin = "pinned creature";

template <class Value>
void drag(const char* kind, const Value& value, const char* words) {
    if (!ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoHoldToOpenOthers)) return;
    ImGui::SetDragDropPayload(kind, &value, sizeof(value));
    ImGui::TextUnformatted(words);
    ImGui::EndDragDropSource();
}

template <class Value>
std::optional<Value> dropped(const char* kind) {
    if (!ImGui::BeginDragDropTarget()) return std::nullopt;
    std::optional<Value> value;
    if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kind)) {
        value.emplace();
        std::memcpy(&*value, payload->Data, sizeof(Value));
    }
    ImGui::EndDragDropTarget();
    return value;
}

}  // namespace

void drag_cell(const PinCreature& creature) {
    drag(kCell, creature, "Drop on the shelf to keep it");
}

void drag_pin(std::size_t place) {
    drag(kPin, place, "Drop on a cell of the grid");
}

std::optional<PinCreature> dropped_cell() {
    return dropped<PinCreature>(kCell);
}

std::optional<std::size_t> dropped_pin() {
    return dropped<std::size_t>(kPin);
}

}  // namespace cambrian
