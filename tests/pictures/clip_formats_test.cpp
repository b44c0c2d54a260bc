#include "core/deflated_text.h"
#include "core/files/file_io.h"
#include "persist/creature/creature_card.h"
#include "pictures/clips/clip_file.h"
#include "pictures/clips/indexed_picture.h"
#include "support/catch.h"
#include "support/temporary_directory.h"

#include <array>
#include <gif_lib.h>

namespace cambrian {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

// A grey sky and a square that is at another place in each picture.
Image picture(int number, Rgb square = {250, 40, 20}) {
    Image image{kWidth, kHeight, {}};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const auto grey = static_cast<std::uint8_t>(100 + 2 * y);
            const bool inside = x >= number && x < number + 6 && y >= 10 && y < 16;
            const Rgb rgb = inside ? square : Rgb{grey, grey, grey};
            image.rgb.insert(image.rgb.end(), rgb.begin(), rgb.end());
        }
    }
    return image;
}

constexpr int kPictures = 8;

ColorCensus census() {
    ColorCensus colors;
    for (int i = 0; i < kPictures; ++i)
        colors.add(picture(i));
    return colors;
}

ClipPlan plan_of(const std::filesystem::path& path, const ColorCensus& colors) {
    return {.path = path,
            .width = kWidth,
            .height = kHeight,
            .frames_a_second = 25.0,
            .frames = kPictures,
            .colors = &colors};
}

Status write(const ClipPlan& plan) {
    auto clip = ClipFile::open(*clip_format_of(plan.path), plan);
    if (!clip) return clip.error();
    for (std::uint64_t i = 0; i < plan.frames; ++i) {
        if (Status added = (*clip)->add(picture(static_cast<int>(i))); !added) return added;
    }
    return (*clip)->finish();
}

int largest_error(const Image& one, const Image& other) {
    REQUIRE(one.rgb.size() == other.rgb.size());
    int largest = 0;
    for (std::size_t i = 0; i < one.rgb.size(); ++i)
        largest = std::max(largest, std::abs(one.rgb[i] - other.rgb[i]));
    return largest;
}

// Reads a GIF with giflib; returns its pictures as they appear, and their delays in 1/100 s.
struct ReadGif {
    std::vector<Image> pictures;
    std::vector<int> delays;
};
ReadGif read_gif(const std::filesystem::path& path) {
    int fault = 0;
    GifFileType* gif = DGifOpenFileName(path.c_str(), &fault);
    REQUIRE(gif != nullptr);
    REQUIRE(DGifSlurp(gif) == GIF_OK);
    ReadGif read;
    Image shown{gif->SWidth, gif->SHeight, {}};
    shown.rgb.resize(static_cast<std::size_t>(3 * gif->SWidth * gif->SHeight));
    for (int i = 0; i < gif->ImageCount; ++i) {
        GraphicsControlBlock control{};
        REQUIRE(DGifSavedExtensionToGCB(gif, i, &control) == GIF_OK);
        read.delays.push_back(control.DelayTime);
        const SavedImage& saved = gif->SavedImages[i];
        const GifImageDesc& place = saved.ImageDesc;
        CHECK(place.ColorMap == nullptr);
        for (int at = 0; at < place.Width * place.Height; ++at) {
            const int index = saved.RasterBits[at];
            if (index == control.TransparentColor) continue;
            const GifColorType& color = gif->SColorMap->Colors[index];
            std::uint8_t* pixel =
                shown.pixel(place.Left + at % place.Width, place.Top + at / place.Width);
            pixel[0] = color.Red;
            pixel[1] = color.Green;
            pixel[2] = color.Blue;
        }
        read.pictures.push_back(shown);
    }
    DGifCloseFile(gif, &fault);
    return read;
}

TEST_CASE("a GIF shows its pictures in colours that are the same in each", "[pictures][clips]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "a.gif";
    const ColorCensus colors = census();
    REQUIRE(write(plan_of(path, colors)));
    const ReadGif read = read_gif(path);
    REQUIRE(read.pictures.size() == kPictures);
    for (int i = 0; i < kPictures; ++i)
        CHECK(largest_error(read.pictures[static_cast<std::size_t>(i)], picture(i)) <= 6);
    CHECK(read.delays == std::vector<int>(kPictures, 4));
}

TEST_CASE("the delays of a GIF add up to its duration at any rate", "[pictures][clips]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "a.gif";
    const ColorCensus colors = census();
    ClipPlan plan = plan_of(path, colors);
    plan.frames_a_second = 30.0;
    plan.frames = 6;
    REQUIRE(write(plan));
    CHECK(read_gif(path).delays == std::vector<int>{3, 4, 3, 3, 4, 3});
}

TEST_CASE("a picture of a clip holds only what changed since the one before", "[pictures][clips]") {
    PictureIndexer indexer(ColorTable(census(), kMostClipColors), kWidth, kHeight, false);
    const IndexedPicture first = indexer.next(picture(0));
    CHECK(first.width == kWidth);
    CHECK(first.height == kHeight);
    CHECK(std::count(first.indices.begin(), first.indices.end(), kUnchanged) == 0);
    const IndexedPicture second = indexer.next(picture(1));
    CHECK(second.x == 0);
    CHECK(second.y == 10);
    CHECK(second.width == 7);
    CHECK(second.height == 6);
    const IndexedPicture same = indexer.next(picture(1));
    CHECK(same.indices == std::vector<std::uint8_t>{kUnchanged});
}

TEST_CASE("a colour table serves small things beside large ones", "[pictures][clips]") {
    ColorCensus colors;
    Image sky{200, 200, {}};
    for (int i = 0; i < 200 * 200; ++i) {
        const auto level = static_cast<std::uint8_t>(i / 200);
        sky.rgb.insert(sky.rgb.end(), {level, level, 255});
    }
    const std::array<Rgb, 3> spots = {{{255, 0, 0}, {0, 255, 0}, {255, 255, 0}}};
    for (std::size_t i = 0; i < spots.size(); ++i)
        std::copy(spots[i].begin(), spots[i].end(), sky.rgb.begin() + 600 * static_cast<int>(i));
    colors.add(sky);
    ColorTable table(colors, 32);
    CHECK(table.colors().size() == 32);
    for (const Rgb& spot : spots)
        CHECK(color_distance(spot.data(), table.colors()[table.nearest(spot.data())].data()) < 60);
}

TEST_CASE("dithering gives the mean of a colour that the table lacks", "[pictures][clips]") {
    ColorCensus colors;
    Image two{2, 1, {100, 100, 100, 110, 110, 110}};
    colors.add(two);
    PictureIndexer indexer(ColorTable(colors, 2), kWidth, kHeight, true);
    const Image grey{kWidth, kHeight, std::vector<std::uint8_t>(3 * kWidth * kHeight, 105)};
    const IndexedPicture mixed = indexer.next(grey);
    const auto light = std::count(mixed.indices.begin(), mixed.indices.end(), 2);
    CHECK(light > kWidth * kHeight / 4);
    CHECK(light < 3 * kWidth * kHeight / 4);
}

TEST_CASE("a moving card is a card, and its chunks are those of an animated PNG",
          "[pictures][clips]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "a.apng";
    const ColorCensus colors = census();
    ClipPlan plan = plan_of(path, colors);
    plan.creature = "the creature";
    REQUIRE(write(plan));
    const std::string bytes = read_file(path, kMaxCardBytes).value();
    CHECK(card_document(bytes, "a.apng").value() == "the creature");
    std::string names;
    std::uint32_t number = 0;
    for (std::size_t at = 8; at < bytes.size();) {
        const auto number_at = [&bytes](std::size_t place) {
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < 4; ++i)
                value = value << 8U | static_cast<std::uint8_t>(bytes[place + i]);
            return value;
        };
        const std::size_t size = number_at(at);
        const std::string name = bytes.substr(at + 4, 4);
        CHECK(number_at(at + 8 + size) ==
              crc32_of(std::string_view(bytes).substr(at + 4, 4 + size)));
        if (name == "acTL") CHECK(number_at(at + 8) == kPictures);
        if (name == "fcTL" || name == "fdAT") CHECK(number_at(at + 8) == number++);
        names += name + ' ';
        at += 12 + size;
    }
    std::string expected = "IHDR iTXt acTL PLTE tRNS fcTL IDAT ";
    for (int i = 1; i < kPictures; ++i)
        expected += "fcTL fdAT ";
    CHECK(names == expected + "IEND ");
}

TEST_CASE("a moving card of more than cards may have is refused and leaves nothing",
          "[pictures][clips]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "a.apng";
    const ColorCensus colors = census();
    ClipPlan plan = plan_of(path, colors);
    std::uint32_t noise = 1;
    for (std::size_t i = 0; i < kMaxCardBytes + 1'000'000; ++i) {
        noise = noise * 1664525U + 1013904223U;
        plan.creature += static_cast<char>(noise >> 24U);
    }
    CHECK_THAT(write(plan).error().message, Catch::Contains("at most 16 MB"));
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a clip that is given up leaves nothing", "[pictures][clips][threads]") {
    const TemporaryDirectory folder;
    const ColorCensus colors = census();
    for (const char* name : {"a.gif", "a.apng"}) {
        auto clip = ClipFile::open(*clip_format_of(name), plan_of(folder.path() / name, colors));
        REQUIRE(clip);
        REQUIRE((*clip)->add(picture(0)));
    }
    CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a name's ending tells the format of a clip, and what it cannot show",
          "[pictures][clips]") {
    CHECK(clip_format_of("a.gif")->label == "GIF");
    CHECK(clip_format_of("a.png") == nullptr);
    CHECK(clip_format_of("a.mp4")->even_sides);
    CHECK(check_clip(*clip_format_of("a.gif"), "a.gif", 31, 31, 50.0));
    CHECK_THAT(check_clip(*clip_format_of("a.gif"), "a.gif", 31, 31, 60.0).error().message,
               Catch::Contains("a GIF shows at most 50 frames a second, found 60"));
    CHECK_THAT(check_clip(*clip_format_of("a.mp4"), "a.mp4", 31, 30, 30.0).error().message,
               Catch::Contains("even"));
}

}  // namespace
}  // namespace cambrian
