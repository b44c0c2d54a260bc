// Pictures drawn without a display, through EGL.

#include "pictures/card_picture.h"
#include "pictures/clip.h"
#include "pictures/curves_picture.h"
#include "pictures/scene/moment.h"
#include "pictures/sheet.h"
#include "render/opengl/offscreen_context.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <set>

namespace cambrian {
namespace {

Subject crawler(double duration = 0.5) {
    const CreatureDocument document{unjudged(test::crawler(test::kinds().creature.catalog))};
    ExperimentSettings settings;
    settings.world.trial.duration = duration;
    auto subject = subject_of(document, settings, "Crawler", test::kinds());
    REQUIRE(subject);
    return std::move(*subject);
}

class Workshop {
public:
    Workshop() {
        context_ = opened(OffscreenContext::create());
        renderer_ = opened(Renderer::create());
        text_rasterizer_ = opened(TextRasterizer::load());
    }
    PictureCanvas canvas(int width, int height) {
        auto canvas = PictureCanvas::create(*renderer_, *text_rasterizer_, width, height);
        REQUIRE(canvas);
        return std::move(*canvas);
    }

private:
    template <class Thing>
    static Thing opened(Result<Thing> thing) {
        INFO((thing ? std::string() : thing.error().message));
        REQUIRE(thing);
        return std::move(*thing);
    }

    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<TextRasterizer> text_rasterizer_;
};

std::size_t colors_in(const Image& image) {
    std::set<std::array<std::uint8_t, 3>> colors;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
        colors.insert({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
    return colors.size();
}

TEST_CASE("sheets, cards and frames of clips have their size and are not empty",
          "[pictures][picture]") {
    Workshop workshop;
    const Subject subject = crawler();
    for (const ThemeKind theme : {ThemeKind::kDark, ThemeKind::kLight}) {
        PictureCanvas canvas = workshop.canvas(400, 300);
        draw_sheet(canvas, subject, palette_of(theme), 6);
        const Image sheet = canvas.finish();
        CHECK(sheet.width == 400);
        CHECK(sheet.height == 300);
        CHECK(sheet.rgb.size() == 400U * 300U * 3U);
        CHECK(colors_in(sheet) > 50);
        draw_card(canvas, subject, palette_of(theme));
        CHECK(colors_in(canvas.finish()) > 50);
        draw_clip_frame(canvas, subject, palette_of(theme), moment_of(subject.motion(), 0.0));
        CHECK(colors_in(canvas.finish()) > 50);
    }
}

TEST_CASE("equal moments give equal pictures, other moments other pictures",
          "[pictures][picture]") {
    Workshop workshop;
    const Subject subject = crawler();
    PictureCanvas canvas = workshop.canvas(160, 120);
    const auto frame = [&](std::uint64_t number) {
        draw_clip_frame(canvas, subject, palette_of(ThemeKind::kDark),
                        moment_of(subject.motion(), clip_time({}, number)));
        return canvas.finish().rgb;
    };
    const auto first = frame(0);
    CHECK(frame(0) == first);
    CHECK(frame(10) != first);
}

TEST_CASE("the smallest and the most unequal sizes can be drawn", "[pictures][picture]") {
    Workshop workshop;
    const Subject subject = crawler();
    for (const auto& [width, height] : {std::pair{64, 64}, {64, 1000}, {1000, 64}}) {
        PictureCanvas canvas = workshop.canvas(width, height);
        for (const int poses : {1, 7, kMostPoses}) {
            draw_sheet(canvas, subject, palette_of(ThemeKind::kDark), poses);
            CHECK(canvas.finish().width == width);
        }
        draw_card(canvas, subject, palette_of(ThemeKind::kDark));
        CHECK(canvas.finish().height == height);
    }
}

TEST_CASE("a curve rises where its values do, between the edges of its band",
          "[pictures][picture]") {
    Workshop workshop;
    PictureCanvas canvas = workshop.canvas(1600, 900);
    const BandedCurve rising{"rising", {0, 50, 100}, {0, 0.4, 0.9}, {0, 0.5, 1}, {0, 0.6, 2}};
    const CurvesLabels labels{"Title", "below", "trials", "score"};
    const auto rows_of_middle = [&](int x) {
        const Image image = canvas.finish();
        std::vector<int> rows;
        for (int y = 0; y < 760; ++y) {
            const std::uint8_t* pixel = image.pixel(x, y);
            if (pixel[0] > 200 && pixel[1] > 130 && pixel[1] < 180 && pixel[2] < 60)
                rows.push_back(y);
        }
        return rows;
    };
    draw_curves(canvas, {rising}, labels, palette_of(ThemeKind::kDark));
    const std::vector<int> early = rows_of_middle(400);
    const std::vector<int> late = rows_of_middle(1400);
    REQUIRE_FALSE(early.empty());
    REQUIRE_FALSE(late.empty());
    CHECK(late.front() < early.front() - 100);
    draw_curves(canvas, {}, labels, palette_of(ThemeKind::kDark));
    CHECK(rows_of_middle(400).empty());
    const std::vector<BandedCurve> many(40, BandedCurve{"no runs yet", {}, {}, {}, {}});
    draw_curves(canvas, many, labels, palette_of(ThemeKind::kLight));
    CHECK(colors_in(canvas.finish()) > 50);
}

TEST_CASE("a clip has one frame for each interval of the trial", "[pictures][clip]") {
    CHECK(clip_frames({.frames_a_second = 30, .speed = 1, .seconds = 2}) == 60);
    CHECK(clip_frames({.frames_a_second = 30, .speed = 0.5, .seconds = 2}) == 120);
    CHECK(clip_frames({.frames_a_second = 25, .speed = 4, .seconds = 2}) == 13);
    CHECK(clip_frames({.frames_a_second = 30, .speed = 1, .seconds = 0}) == 1);
}

TEST_CASE("poses are spread evenly over the motion", "[pictures][moment]") {
    const Subject subject = crawler();
    CHECK(even_times(subject.motion(), 3) ==
          std::vector<double>{0.0, 0.5 * subject.motion().length(), subject.motion().length()});
    CHECK(even_times(subject.motion(), 1).size() == 1);
    CHECK(telling_time(subject.motion()) >= 0.1);
    CHECK(telling_time(subject.motion()) <= 0.4);
}

TEST_CASE("a score is shown only with the trial that it was computed from", "[pictures][subject]") {
    ExperimentSettings settings;
    settings.world.trial.duration = 0.5;
    CreatureDocument document{unjudged(test::crawler(test::kinds().creature.catalog),
                                       std::make_shared<const ExperimentSettings>(settings))};
    document.notes.unit = "BL/s";
    const auto score = [&](std::uint64_t digest) {
        change_individual(document.creature, [&](Individual& individual) {
            individual.evaluated = true;
            individual.result.fitness = 42.0;
            individual.result.digest = digest;
        });
    };
    score(0);
    const auto own = subject_of(document, settings, "", test::kinds());
    REQUIRE(own);
    CHECK(own->fitness == "42.000 BL/s");
    CHECK(own->verified == false);
    score(own->trial.record.digest);
    CHECK(subject_of(document, settings, "", test::kinds()).value().verified == true);
    settings.world.environment.gravity *= 0.5;
    const auto elsewhere = subject_of(document, settings, "", test::kinds());
    REQUIRE(elsewhere);
    CHECK(elsewhere->fitness != "42 BL/s");
    CHECK_FALSE(elsewhere->verified);
}

}  // namespace
}  // namespace cambrian
