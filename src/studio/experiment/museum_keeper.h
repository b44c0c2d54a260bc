#pragma once

// Puts the champion of each run of the window into the museum when the run ends.

#include "evolution/engine/snapshot.h"
#include "studio/background/services.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace cambrian {

inline constexpr std::size_t kMuseumGenerations = 10;  // shorter runs do not count

class MuseumKeeper {
public:
    // The references in `services` must outlive the object.
    explicit MuseumKeeper(const Services& services) : services_(services) {}

    // Uses this folder from now on; an empty path keeps nothing.
    void keep_in(const std::filesystem::path& folder) { folder_ = folder; }
    // Must be called once a frame. When another run is at hand, the champion of the one before goes
    // into the museum in the background.
    void see(const EvolutionSnapshot& snapshot);
    // Keeps the champion of the present run at once, because the window closes.
    void close();

private:
    Services services_;
    std::filesystem::path folder_;
    std::uint64_t run_ = 0;                     // EvolutionSnapshot::experiment
    std::optional<JudgedIndividual> champion_;  // of its newest generation
    std::size_t generations_ = 0;
};

}  // namespace cambrian
