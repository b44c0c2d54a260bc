#pragma once

// Writes files that take long on a thread of its own, one after the other, so that other files do
// not wait.

#include "core/result.h"
#include "simulator/trial_watch.h"
#include "studio/background/background_worker.h"

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

// The file that is being written.
struct FileProgress {
    std::string name;
    double share = 0.0;  // of the work that is done, 0 to 1
    bool stopping = false;
};

struct FinishedFile {
    std::filesystem::path path;
    Status status;
    bool stopped = false;  // by the user
};

// Writes a file whole or leaves nothing. Notes its progress, and gives up when asked to stop.
using FileWork = std::function<Status(const TrialWatch&)>;

class LongFiles {
public:
    // `length` is the amount of the work, in the unit of its progress.
    void write(const std::filesystem::path& path, double length, FileWork work);
    // Gives up the file that is being written.
    void stop();
    // Returns what is being written; no name if nothing is.
    FileProgress progress() const;
    // Must be called once a frame; returns the files that are finished, each once.
    std::vector<FinishedFile> take_finished();

private:
    struct Making {
        std::filesystem::path path;
        double length = 0.0;
        std::atomic<double> time = 0.0;
        std::stop_source stop;
    };

    std::deque<std::shared_ptr<Making>> making_;  // the one being written first
    std::vector<FinishedFile> finished_;
    BackgroundWorker worker_;  // last member, so that it ends before the others
};

}  // namespace cambrian
