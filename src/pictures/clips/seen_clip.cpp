#include "pictures/clips/seen_clip.h"

#include "pictures/clips/clip_file.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr std::uint64_t kCountedSeen = 8;  // pictures whose colours are counted

// Unpacks the pictures of one clip.
class SeenPictures {
public:
    explicit SeenPictures(const SeenClip& seen) : seen_(seen) {}

    // Returns the picture that was seen at a time, which is not before the first.
    Result<Image> at(double time) {
        const auto later =
            std::find_if(seen_.pictures.begin() + 1, seen_.pictures.end(),
                         [time](const SeenPicture& each) { return each.time > time; });
        Image image{seen_.width, seen_.height, {}};
        const std::size_t size =
            3 * static_cast<std::size_t>(seen_.width) * static_cast<std::size_t>(seen_.height);
        const Result<std::string> bytes = decoder_.decode(*(later - 1)->packed, {}, size);
        if (!bytes) return bytes.error();
        image.rgb.assign(bytes->begin(), bytes->end());
        return image;
    }

private:
    const SeenClip& seen_;
    DeltaDecoder decoder_;
};

}  // namespace

std::shared_ptr<const std::string> PicturePacker::pack(const Image& picture) {
    const std::string_view bytes(reinterpret_cast<const char*>(picture.rgb.data()),
                                 picture.rgb.size());
    return std::make_shared<const std::string>(encoder_.encode(bytes, {}));
}

Status write_seen_clip(const SeenClip& seen, const ClipFormat& format,
                       const std::filesystem::path& path, const TrialWatch& watch) {
    SeenPictures pictures(seen);
    const double begin = seen.pictures.front().time;
    const double length = std::max(0.0, seen.end - begin);
    const auto frames =
        static_cast<std::uint64_t>(std::max(1.0, std::round(length * format.usual_rate)));
    ColorCensus census;
    for (std::uint64_t i = 0; format.few_colors && i < kCountedSeen; ++i) {
        const double share = static_cast<double>(i) / (kCountedSeen - 1);
        const Result<Image> picture = pictures.at(begin + share * length);
        if (!picture) return picture.error();
        census.add(*picture);
    }
    auto clip = ClipFile::open(format, {.path = path,
                                        .width = seen.width,
                                        .height = seen.height,
                                        .frames_a_second = format.usual_rate,
                                        .frames = frames,
                                        .colors = &census});
    if (!clip) return clip.error();
    for (std::uint64_t frame = 0; frame < frames; ++frame) {
        if (watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
        const double time = static_cast<double>(frame) / format.usual_rate;
        Result<Image> picture = pictures.at(begin + time);
        if (!picture) return picture.error();
        watch.note(time);
        if (Status added = (*clip)->add(*std::move(picture)); !added) return added;
    }
    return (*clip)->finish();
}

}  // namespace cambrian
