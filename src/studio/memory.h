#pragma once

// Stores the state that the studio keeps between two runs of the program in a folder.

#include "studio/background/services.h"
#include "studio/preferences.h"

#include <filesystem>

namespace cambrian {

class Memory {
public:
    // `kept` is the state that was read when the program started.
    explicit Memory(Preferences kept) : kept_(std::move(kept)) {}

    // Stores the state in this folder from now on; an empty path stores nothing.
    void use(const std::filesystem::path& folder) { folder_ = folder; }
    // The experiment to continue, empty if there is none.
    std::filesystem::path last_experiment() const;
    // The file of the experiment that was stored last.
    const std::string& experiment() const { return kept_.experiment; }
    // Returns whether it is time to look for changes again; `now` is in seconds.
    bool due(double now) const;
    // Writes the present state in the background if it changed.
    void keep(const Preferences& present, const Services& services);

private:
    std::filesystem::path folder_;
    Preferences kept_;
    double kept_at_ = 0.0;  // s; time at which changes were looked for last
};

}  // namespace cambrian
