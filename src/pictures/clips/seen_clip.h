#pragma once

// Pictures kept in memory as they were seen, to be written as a clip later.

#include "core/delta_text.h"
#include "pictures/clips/clip_format.h"
#include "simulator/trial_watch.h"

#include <memory>
#include <string>
#include <vector>

namespace cambrian {

struct SeenPicture {
    double time = 0.0;                          // s
    std::shared_ptr<const std::string> packed;  // see PicturePacker; the same may follow itself
};

struct SeenClip {
    int width = 0;  // pixels
    int height = 0;
    double end = 0.0;                   // s; the last picture is seen until then
    std::vector<SeenPicture> pictures;  // the oldest first
};

class PicturePacker {
public:
    std::shared_ptr<const std::string> pack(const Image& picture);

private:
    DeltaEncoder encoder_;
};

// Writes a clip at the format's usual rate; it has at least one picture.
Status write_seen_clip(const SeenClip& seen, const ClipFormat& format,
                       const std::filesystem::path& path, const TrialWatch& watch);

}  // namespace cambrian
