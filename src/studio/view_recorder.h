#pragma once

// Keeps what was seen in a part of the window during the last seconds: about 20 MB of
// pictures.

#include "pictures/clips/seen_clip.h"
#include "render/opengl/framebuffer.h"
#include "render/opengl/pixels.h"
#include "studio/background/background_worker.h"

#include <deque>
#include <memory>
#include <optional>

namespace cambrian {

class ViewRecorder {
public:
    static constexpr double kSeconds = 10.0;  // s that are kept

    // Takes a picture of a rectangle of the window's framebuffer if one is due; `now` is in s. May
    // be called only between a frame's drawing and its display.
    void take(const ReadArea& area, double now);
    // Returns what was seen up to `now`; without pictures if nothing was.
    SeenClip seen(double now) const;

private:
    // A picture that is being packed.
    struct Kept {
        double time = 0.0;
        std::shared_ptr<const std::string> packed;
    };
    void fit_to(const ReadArea& area);

    ReadArea area_;
    std::optional<Framebuffer> small_;  // as large as the pictures
    std::deque<std::shared_ptr<Kept>> kept_;
    double due_ = 0.0;  // s; time of the next picture
    std::shared_ptr<PicturePacker> packer_ = std::make_shared<PicturePacker>();
    BackgroundWorker worker_;
};

}  // namespace cambrian
