#pragma once

// Keeps what the studio remembers between two runs of the program up to date in a folder.

#include "studio/background/services.h"
#include "studio/remembered.h"

#include <filesystem>

namespace cambrian {

class Memory {
public:
    // What is remembered when the program begins.
    explicit Memory(Remembered kept) : kept_(std::move(kept)) {}

    // Keeps it in this folder from now on; an empty path keeps nothing.
    void use(const std::filesystem::path& folder) { folder_ = folder; }
    // The experiment to go on with, empty if there is none.
    std::filesystem::path last_experiment() const;
    // The file of the experiment as last remembered.
    const std::string& experiment() const { return kept_.experiment; }
    // Whether it is time to look for changes again; `now` is in seconds.
    bool due(double now) const;
    // Writes the present state in the background if it changed.
    void keep(const Remembered& present, const Services& services);

private:
    std::filesystem::path folder_;
    Remembered kept_;
    double kept_at_ = 0.0;  // s
};

}  // namespace cambrian
