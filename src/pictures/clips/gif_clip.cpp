// GIF, by giflib. Pictures overlay each other; what did not change is transparent.

#include "core/files/file_errors.h"
#include "core/files/pending_file.h"
#include "pictures/clips/clip_format.h"
#include "pictures/clips/indexed_picture.h"

#include <array>
#include <cmath>
#include <gif_lib.h>
#include <utility>

namespace cambrian {
namespace {

// Browsers show a picture for 0.1 s if it asks for less than 0.02 s.
constexpr double kMostGifRate = 50.0;          // Hz
constexpr double kDelays = 100.0;              // units of a delay in a second
constexpr std::size_t kGifBuffer = 1'000'000;  // bytes that are written at once

class GifClip final : public ClipEncoder {
public:
    GifClip(const ClipPlan& plan, PendingFile file)
        : rate_(plan.frames_a_second),
          indexer_(ColorTable(*plan.colors, kMostClipColors), plan.width, plan.height,
                   plan.dithered),
          file_(std::move(file)) {}
    ~GifClip() override { close(); }
    GifClip(const GifClip&) = delete;
    GifClip& operator=(const GifClip&) = delete;

    Status begin(const ClipPlan& plan) {
        int fault = 0;
        gif_ = EGifOpen(this, append_to_clip, &fault);
        if (gif_ == nullptr) return failure(fault);
        EGifSetGifVersion(gif_, true);
        std::array<GifColorType, kMostClipColors + 1> colors = {};
        for (std::size_t i = 0; i < indexer_.colors().size(); ++i) {
            const Rgb& rgb = indexer_.colors()[i];
            colors[i + 1] = {rgb[0], rgb[1], rgb[2]};
        }
        ColorMapObject* const map =
            GifMakeMapObject(static_cast<int>(colors.size()), colors.data());
        const bool put =
            map != nullptr && EGifPutScreenDesc(gif_, plan.width, plan.height, 8, 0, map) == GIF_OK;
        GifFreeMapObject(map);
        if (!put || !put_repetition()) return failure(gif_->Error);
        return {};
    }

    Status add(const Image& picture) override {
        const IndexedPicture& changed = indexer_.next(picture);
        if (!put_delay()) return failure(gif_->Error);
        if (EGifPutImageDesc(gif_, changed.x, changed.y, changed.width, changed.height, false,
                             nullptr) != GIF_OK)
            return failure(gif_->Error);
        line_.resize(static_cast<std::size_t>(changed.width));
        for (int y = 0; y < changed.height; ++y) {
            line_.assign(changed.row(y), changed.row(y) + changed.width);
            if (EGifPutLine(gif_, line_.data(), changed.width) != GIF_OK)
                return failure(gif_->Error);
        }
        return bytes_.size() < kGifBuffer ? Status() : flush();
    }

    Status finish() override {
        if (const int fault = close(); fault != 0) return failure(fault);
        if (Status flushed = flush(); !flushed) return flushed;
        return file_.commit();
    }

private:
    static int append_to_clip(GifFileType* gif, const GifByteType* bytes, int count) {
        static_cast<GifClip*>(gif->UserData)
            ->bytes_.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
        return count;
    }

    // Lets it be shown again and again.
    bool put_repetition() {
        constexpr std::array<unsigned char, 3> forever = {1, 0, 0};
        return EGifPutExtensionLeader(gif_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
               EGifPutExtensionBlock(gif_, 11, "NETSCAPE2.0") == GIF_OK &&
               EGifPutExtensionBlock(gif_, forever.size(), forever.data()) == GIF_OK &&
               EGifPutExtensionTrailer(gif_) == GIF_OK;
    }

    // Delays are whole hundredths of a second, which on average give the rate.
    bool put_delay() {
        const auto end_of = [this](std::uint64_t frame) {
            return std::llround(kDelays * static_cast<double>(frame) / rate_);
        };
        const auto delay = static_cast<int>(end_of(frame_ + 1) - end_of(frame_));
        ++frame_;
        const GraphicsControlBlock control = {DISPOSE_DO_NOT, false, delay, kUnchanged};
        std::array<GifByteType, 4> bytes = {};
        const std::size_t size = EGifGCBToExtension(&control, bytes.data());
        return EGifPutExtension(gif_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size),
                                bytes.data()) == GIF_OK;
    }

    Status flush() {
        const int fault = file_.write(std::exchange(bytes_, {}));
        return fault == 0 ? Status() : write_outcome(file_.target(), fault);
    }

    // Returns giflib's code of a fault, or 0.
    int close() {
        int fault = 0;
        if (gif_ != nullptr && EGifCloseFile(std::exchange(gif_, nullptr), &fault) == GIF_OK)
            return 0;
        return fault;
    }

    Status failure(int fault) const {
        const char* words = GifErrorString(fault);
        return Error{"cannot make " + file_.target().string() + ": " +
                     (words == nullptr ? "giflib gives no reason" : words)};
    }

    double rate_;  // Hz
    PictureIndexer indexer_;
    PendingFile file_;
    std::string bytes_;  // not yet in the file
    std::vector<GifPixelType> line_;
    std::uint64_t frame_ = 0;
    GifFileType* gif_ = nullptr;
};

Result<std::unique_ptr<ClipEncoder>> open_gif(const ClipPlan& plan) {
    auto file = PendingFile::beside(plan.path);
    if (!file) return file.error();
    auto clip = std::make_unique<GifClip>(plan, *std::move(file));
    if (Status begun = clip->begin(plan); !begun) return begun.error();
    return std::unique_ptr<ClipEncoder>(std::move(clip));
}

}  // namespace

ClipFormat gif_format() {
    return {.ending = ".gif",
            .label = "GIF",
            .usual_width = 640,
            .usual_height = 360,
            .usual_rate = 20.0,
            .most_rate = kMostGifRate,
            .slowness = "browsers slow down faster ones",
            .few_colors = true,
            .open = open_gif};
}

}  // namespace cambrian
