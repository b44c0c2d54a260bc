#pragma once

// The open preserve: its thread, its newest picture, and the creature that was picked.

#include "core/threads/thread_share.h"
#include "studio/background/feedback.h"
#include "studio/preserve/opened_world.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

namespace cambrian {

class OpenPreserve {
public:
    OpenPreserve(OpenedWorld opened, const ThreadShare& threads);

    // Sends a command to the thread, as soon as its inbox has room.
    void send(PreserveCommand command) { engine_.send(std::move(command)); }
    // Must be called once a frame: reads the newest picture and writes its news to the log.
    void update(Feedback& feedback);

    // Never null.
    const std::shared_ptr<const PreservePicture>& picture() const { return picture_; }
    const SettingsPtr& settings() const { return settings_; }
    const std::filesystem::path& file() const { return file_; }

    void pick(std::uint64_t number);
    // The picked creature as it was last seen; null if none is.
    const ResidentPicture* picked() const { return picked_ ? &*picked_ : nullptr; }

private:
    void follow_picked(Feedback& feedback);
    void tell_news(Feedback& feedback);
    void log_state(Feedback& feedback);

    SettingsPtr settings_;
    std::filesystem::path file_;
    PreserveEngine engine_;
    std::shared_ptr<const PreservePicture> picture_;
    std::optional<ResidentPicture> picked_;
    std::uint64_t told_ = 0;  // news of this id and before are told
    double logged_ = -1.0;    // s; time of the last state in the log
};

}  // namespace cambrian
