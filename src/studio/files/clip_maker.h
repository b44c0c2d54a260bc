#pragma once

// Clips of a creature's trial, as the window offers and writes them.

#include "pictures/clip.h"
#include "studio/files/creature_exhibit.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// What the user chooses about a clip of a creature.
struct ClipChoice {
    const ClipFormat* format = nullptr;
    bool card = false;  // a creature card that moves
    int width = 0;      // pixels
    int height = 0;
    double seconds = 0.0;  // s of the trial
    double speed = 1.0;    // 1 is real time
};

// A kind of clip as the window offers it: a format, or a creature card that moves.
struct ClipKind {
    std::string label;
    std::string_view ending;
    const ClipFormat* format = nullptr;
    bool card = false;
};
const std::vector<ClipKind>& clip_kinds();
// Returns the kind that a name's ending means; null for other names.
const ClipKind* clip_kind_of(std::string_view name);
inline bool is_clip_name(std::string_view name) {
    return clip_kind_of(name) != nullptr;
}

// A clip of a creature's trial.
struct TrialClip {
    std::filesystem::path path;
    CreatureDocument document;
    std::string title;  // title for a creature without a name
    ExperimentSettings settings = {};
    ClipChoice choice;
    Palette palette;
    std::optional<std::uint32_t> generation = {};  // of its birth, which cards tell
};

// Draws and writes a clip; leaves nothing if it is stopped.
Status write_trial_clip(TrialClip& clip, const EvolutionKinds& kinds, const TrialWatch& watch);

}  // namespace cambrian
