#pragma once

// Begins a preserve or reads one from its file. These functions may take long.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "preserve/engine/preserve_engine.h"
#include "world/terrain_settings.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

// A preserve that is ready for its thread.
struct OpenedWorld {
    PreserveStart start;
    std::filesystem::path file;         // empty: it is not kept
    std::vector<std::string> warnings;  // about its file
    Pins pins = {};
};

// The creatures with which a preserve begins.
enum class FounderChoice : std::uint8_t {
    kShown,
    kStarred,
    kPicked,
    kSwimmers,  // among the samples
    kWalkers,   // among the samples
    kRandom
};

inline constexpr std::array kFounderChoices = {FounderChoice::kShown,   FounderChoice::kStarred,
                                               FounderChoice::kPicked,  FounderChoice::kSwimmers,
                                               FounderChoice::kWalkers, FounderChoice::kRandom};

// Returns whether the founders are given by a choice itself.
inline bool is_open_choice(FounderChoice choice) {
    return choice >= FounderChoice::kSwimmers;
}

struct WorldPlan {
    std::filesystem::path settings;  // file of the laws
    bool wraps = false;              // edges meet, whatever the file says
    TerrainSettings ground = {};     // unless it is flat, in place of the file's
    FounderChoice choice = FounderChoice::kRandom;
    std::vector<GenomePtr> founders;         // unless the choice is open
    std::filesystem::path samples;           // folder
    std::optional<std::uint64_t> seed = {};  // none: that of the settings
    std::filesystem::path file;  // that will keep it; one of that name is renamed. Empty for none.
};

// Returns the name under which the preserve before the present one is kept.
std::filesystem::path preserve_before(const std::filesystem::path& file);

Result<OpenedWorld> begin_world(const WorldPlan& plan, const EvolutionKinds& kinds);
Result<OpenedWorld> open_world(const std::filesystem::path& path, const EvolutionKinds& kinds);
// Copies a file up to a snapshot, the last one unless a tick is given, and opens the copy. If that
// fails, the original is opened with a warning.
Result<OpenedWorld> branch_world(const std::filesystem::path& from,
                                 std::optional<std::uint64_t> tick, const std::filesystem::path& to,
                                 const EvolutionKinds& kinds);

}  // namespace cambrian
