// Animated PNG: a PNG picture with further pictures in chunks of their own, which programs that
// show only the first one skip. The creature file is inside as it is in a card.

#include "core/deflated_text.h"
#include "core/files/file_errors.h"
#include "core/files/pending_file.h"
#include "persist/creature/creature_card.h"
#include "pictures/clips/clip_format.h"
#include "pictures/clips/indexed_picture.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kMostPngRate = 60.0;  // Hz; of most displays
constexpr int kPngLevel = 7;           // of deflating; higher ones save 2 % in three times the time
// Readers refuse longer chunks (persist/creature/creature_card.cpp).
constexpr std::size_t kLongestChunk = 1'000'000;  // bytes

void put_short(std::string& bytes, unsigned value) {
    bytes += static_cast<char>(value >> 8U);
    bytes += static_cast<char>(value);
}

void put_long(std::string& bytes, std::uint32_t value) {
    put_short(bytes, value >> 16U);
    put_short(bytes, value & 0xFFFFU);
}

void put_size(std::string& bytes, int value) {
    put_long(bytes, static_cast<std::uint32_t>(value));
}

class MovingPng final : public ClipEncoder {
public:
    MovingPng(const ClipPlan& plan, PendingFile file)
        : rate_(plan.frames_a_second),
          limited_(!plan.creature.empty()),
          indexer_(ColorTable(*plan.colors, kMostClipColors), plan.width, plan.height,
                   plan.dithered),
          deflater_(kPngLevel),
          file_(std::move(file)) {}

    Status begin(const ClipPlan& plan) {
        bytes_ = "\x89PNG\r\n\x1a\n";
        std::string header;
        put_size(header, plan.width);
        put_size(header, plan.height);
        header += std::string("\x08\x03\0\0\0", 5);  // indices of eight bits
        put_chunk("IHDR", header);
        if (!plan.creature.empty()) put_chunk("iTXt", text_of(plan.creature));
        std::string pictures;
        put_long(pictures, static_cast<std::uint32_t>(plan.frames));
        put_long(pictures, 0);  // shown again and again
        put_chunk("acTL", pictures);
        std::string colors(3, '\0');  // of kUnchanged
        for (const Rgb& rgb : indexer_.colors())
            colors.append(rgb.begin(), rgb.end());
        put_chunk("PLTE", colors);
        put_chunk("tRNS", std::string(1, '\0'));
        return flush();
    }

    Status add(const Image& picture) override {
        const IndexedPicture& changed = indexer_.next(picture);
        const bool first = numbers_ == 0;
        put_control(changed, first);
        lines_.clear();
        for (int y = 0; y < changed.height; ++y) {
            lines_ += '\0';  // as they are, without a filter
            lines_.append(reinterpret_cast<const char*>(changed.row(y)),
                          static_cast<std::size_t>(changed.width));
        }
        std::string_view left = deflater_.deflate(lines_);
        while (!left.empty()) {
            std::string data;
            if (!first) put_long(data, numbers_++);
            data += left.substr(0, kLongestChunk);
            left.remove_prefix(std::min(left.size(), kLongestChunk));
            put_chunk(first ? "IDAT" : "fdAT", data);
        }
        return flush();
    }

    Status finish() override {
        put_chunk("IEND", {});
        if (Status flushed = flush(); !flushed) return flushed;
        return file_.commit();
    }

private:
    std::string text_of(const std::string& creature) {
        std::string text(kCardKeyword);
        text += std::string("\0\x01\0\0\0", 5);  // compressed, in no language
        text += deflater_.deflate(creature);
        return text;
    }

    void put_chunk(std::string_view name, std::string_view data) {
        put_long(bytes_, static_cast<std::uint32_t>(data.size()));
        const std::size_t checked = bytes_.size();
        bytes_ += name;
        bytes_ += data;
        put_long(bytes_, crc32_of(std::string_view(bytes_).substr(checked)));
    }

    void put_control(const IndexedPicture& changed, bool first) {
        std::string control;
        put_long(control, numbers_++);
        for (const int value : {changed.width, changed.height, changed.x, changed.y})
            put_size(control, value);
        put_short(control, 1000);  // a delay, as a fraction of a second
        put_short(control, static_cast<unsigned>(std::lround(1000.0 * rate_)));
        control += '\0';                   // it stays
        control += first ? '\0' : '\x01';  // over the one before
        put_chunk("fcTL", control);
    }

    Status flush() {
        written_ += bytes_.size();
        if (limited_ && written_ > kMaxCardBytes) {
            return Error{fmt::format(
                "cannot make {}: a picture with a creature inside has at most {} MB; expected "
                "fewer seconds, fewer frames a second or a smaller size",
                file_.target().string(), kMaxCardBytes / 1'000'000)};
        }
        const int fault = file_.write(std::exchange(bytes_, {}));
        return fault == 0 ? Status() : write_outcome(file_.target(), fault);
    }

    double rate_;   // Hz
    bool limited_;  // whether it must remain as small as a card
    PictureIndexer indexer_;
    Deflater deflater_;
    PendingFile file_;
    std::string bytes_;          // not yet in the file
    std::size_t written_ = 0;    // bytes
    std::uint32_t numbers_ = 0;  // of chunks of moving pictures so far
    std::string lines_;
};

Result<std::unique_ptr<ClipEncoder>> open_moving_png(const ClipPlan& plan) {
    auto file = PendingFile::beside(plan.path);
    if (!file) return file.error();
    auto clip = std::make_unique<MovingPng>(plan, *std::move(file));
    if (Status begun = clip->begin(plan); !begun) return begun.error();
    return std::unique_ptr<ClipEncoder>(std::move(clip));
}

}  // namespace

ClipFormat moving_png_format() {
    return {.ending = ".apng",
            .label = "animated PNG",
            .usual_width = 640,
            .usual_height = 360,
            .usual_rate = 20.0,
            .most_rate = kMostPngRate,
            .slowness = "displays show no more",
            .few_colors = true,
            .embeds = true,
            .open = open_moving_png};
}

}  // namespace cambrian
