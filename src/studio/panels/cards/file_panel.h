#pragma once

#include "studio/frame/panel.h"

#include <array>
#include <string>

namespace cambrian {

// Chooses a file to open or a name to save under; drawn by the studio itself, over the viewport,
// without stopping anything else.
class FilePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_places(const FrameContext& frame, Requests& out);
    void draw_entries(const FrameContext& frame, Requests& out);
    void draw_format();
    void draw_name(const FrameContext& frame, Requests& out);
    void write_name(const std::string& name);
    void confirm(const FrameContext& frame, Requests& out) const;

    unsigned opening_ = 0;           // the opening its fields were last reset for
    std::array<char, 1024> name_{};  // of the file
    bool focus_wanted_ = false;
};

}  // namespace cambrian
