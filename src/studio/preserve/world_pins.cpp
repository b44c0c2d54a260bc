#include "studio/preserve/world_pins.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

std::uint64_t newest_in(const PreservePicture& picture) {
    return picture.residents.empty() ? 0 : picture.residents.back().life.number;
}

}  // namespace

void WorldPins::begin(Pins pins, const PreservePicture& picture) {
    pins_ = std::move(pins);
    taken_ = pins_;
    newest_ = newest_in(picture);
}

void WorldPins::toggle(std::uint64_t creature) {
    if (pins_.creatures.erase(creature) == 0) pins_.creatures.insert(creature);
}

void WorldPins::follow(const PreservePicture& picture) {
    if (pins_.inherited) pin_children(picture);
    newest_ = std::max(newest_, newest_in(picture));
    std::erase_if(pins_.creatures,
                  [&](std::uint64_t number) { return picture.find(number) == nullptr; });
}

// Parents come before their children, so grandchildren are pinned, too.
void WorldPins::pin_children(const PreservePicture& picture) {
    for (const ResidentPicture& each : picture.residents) {
        if (each.life.number <= newest_) continue;
        const auto& parents = each.life.parents;
        if (std::any_of(parents.begin(), parents.end(),
                        [&](std::uint64_t parent) { return pins_.creatures.contains(parent); }))
            pins_.creatures.insert(each.life.number);
    }
}

bool WorldPins::take_change() {
    return std::exchange(taken_, pins_) != pins_;
}

}  // namespace cambrian
