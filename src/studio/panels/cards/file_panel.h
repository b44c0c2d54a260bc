#pragma once

#include "studio/files/typed_path.h"
#include "studio/frame/panel.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

// Chooses a file to open or a name to save under. The studio draws this dialog itself, over the
// viewport, and everything else goes on meanwhile.
class FilePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_places(const FrameContext& frame, Requests& out);
    void draw_entries(const FrameContext& frame, Requests& out);
    void draw_format(const FrameContext& frame, Requests& out);
    void draw_clip_choices(FileTask task);
    std::size_t& length_of(FileTask task);
    ClipChoice clip_choice(FileTask task);
    void draw_name(const FrameContext& frame, Requests& out);
    void begin_name(const std::string& name);
    void write_name(const std::string& name);
    void draw_caption(const TypedPath& typed) const;
    void confirm(const FrameContext& frame, Requests& out);

    unsigned opening_ = 0;  // the value of FileBrowser::opened when the fields were reset last
    std::array<char, 1024> name_{};  // typed file name
    std::filesystem::path warned_;   // existing file that the next Save replaces
    std::string refused_;            // the name that was refused last
    bool focus_wanted_ = false;
    // What is chosen about a clip: places in the lists of file_panel.cpp.
    struct {
        std::size_t kind = 0;
        std::size_t length = 1;
        std::size_t film_length = 0;  // of each champion
        std::size_t race_length = 3;
        std::size_t speed = 2;
        std::size_t size = 0;
    } clip_;
    std::vector<std::string> missing_;  // why each kind of clip cannot be written; empty if it can
};

}  // namespace cambrian
