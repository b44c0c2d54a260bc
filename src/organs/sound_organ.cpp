// A voice: calls from the middle of the part in one of four bands, as loud as its signal.

#include "organs/kinds.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

void call(const OrganSite& site, double signal, Emissions& emissions) {
    const double loudness = std::clamp(signal, 0.0, 1.0);
    if (!(loudness > 0.0)) return;
    emissions.sounds.push_back(
        {site.scene.part_center(site.index), static_cast<int>(site.parameters[0]), loudness});
}

std::string call_in_words(std::span<const double> parameters) {
    const int band = static_cast<int>(parameters[0]);
    return fmt::format("Calls while its signal is above 0; ears for sound {} hear it.", band + 1);
}

}  // namespace

void add_sound_organ(OrganRegistry& organs) {
    organs.add({.id = "sound",
                .label = "Voice",
                .parameters = {{.name = "band",
                                .key = "band",
                                .low = 0.0,
                                .high = kSoundBands - 1,
                                .whole = true,
                                .help = "Band of sound in which it calls."}},
                .act = call,
                .words = call_in_words,
                .mark = OrganMark::kArcs,
                .sounds = true});
}

}  // namespace cambrian
