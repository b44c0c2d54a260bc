#include "pictures/card_picture.h"

#include "core/text/pretty_text.h"
#include "pictures/scene/moment.h"
#include "pictures/scene/scene_builder.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cambrian {
namespace {

constexpr double kCardMargin = 44.0;     // pixels, for a card of the usual size
constexpr double kPortraitShare = 0.76;  // share of the large picture that the creature fills
constexpr double kStripShare = 0.82;
constexpr int kStripPoses = 5;

// Maps the usual card, scaled and centred, to a card of any size.
class CardRoom {
public:
    explicit CardRoom(const PictureCanvas& canvas)
        : unit(std::min(canvas.width() / static_cast<double>(kCardWidth),
                        canvas.height() / static_cast<double>(kCardHeight))),
          left_(0.5 * (canvas.width() - unit * kCardWidth)),
          top_(0.5 * (canvas.height() - unit * kCardHeight)) {}

    double x(double usual) const { return left_ + unit * usual; }
    double y(double usual) const { return top_ + unit * usual; }
    Area area(const Area& usual) const {
        const double left = std::round(x(usual.x));
        const double top = std::round(y(usual.y));
        return {left, top, std::round(x(usual.right())) - left,
                std::round(y(usual.bottom())) - top};
    }

    const double unit;

private:
    double left_;
    double top_;
};

struct Fact {
    std::string value;
    std::string label;
};

std::vector<Fact> facts_of(const Subject& subject) {
    const Phenotype& phenotype = subject.phenotype();
    std::vector<Fact> facts = {{std::to_string(phenotype.parts.size()), "parts"}};
    for (const CountedMuscles& muscles : muscles_of(phenotype))
        facts.push_back({std::to_string(muscles.number), fmt::format("{}s", muscles.noun)});
    facts.push_back({std::to_string(phenotype.network.order.size()), "neurons"});
    facts.push_back({measured(subject.mass, "kg"), "mass"});
    if (subject.generation) facts.push_back({std::to_string(*subject.generation), "generation"});
    return facts;
}

void add_heading(PictureCanvas& canvas, const CardRoom& at, const Subject& subject,
                 const Palette& palette) {
    const double unit = at.unit;
    const Ink name{Typeface::kStrong, 58.0 * unit, palette.text};
    const Ink score{Typeface::kStrong, 46.0 * unit, palette.accent};
    const Ink goal{Typeface::kRegular, 26.0 * unit, palette.muted};
    const double score_width =
        canvas.text_rasterizer().width(subject.fitness, score.typeface, score.size);
    const double width = unit * (kCardWidth - 2.0 * kCardMargin) - score_width - 28.0 * unit;
    canvas.add_text(at.x(kCardMargin), at.y(782), subject.name, name, Align::kLeft, width);
    canvas.add_text(at.x(kCardWidth - kCardMargin), at.y(782), subject.fitness, score,
                    Align::kRight);
    canvas.add_text(at.x(kCardWidth - kCardMargin), at.y(822), subject.goal, goal, Align::kRight);
    // The colour of the creature's lineage.
    canvas.add_box(at.area({kCardMargin, 806, 72, 8}), 4.0 * unit,
                   color_of_hue(subject.hue(), 0.70, 0.12));
}

void add_facts(PictureCanvas& canvas, const CardRoom& at, const Subject& subject,
               const Palette& palette) {
    const std::vector<Fact> facts = facts_of(subject);
    const Ink value{Typeface::kStrong, 34.0 * at.unit, palette.text};
    const Ink label{Typeface::kRegular, 21.0 * at.unit, palette.muted};
    const double column = (kCardWidth - 2.0 * kCardMargin) / static_cast<double>(facts.size());
    double x = kCardMargin;
    for (const Fact& fact : facts) {
        canvas.add_text(at.x(x), at.y(896), fact.value, value);
        canvas.add_text(at.x(x), at.y(926), fact.label, label);
        x += column;
    }
}

void add_strip(PictureCanvas& canvas, const CardRoom& at, const Subject& subject,
               const Palette& palette) {
    constexpr double gap = 12.0;
    constexpr double height = 190.0;
    const double width = (kCardWidth - 2.0 * kCardMargin + gap) / kStripPoses - gap;
    MomentStyle style{
        .palette = palette, .label_size = 13.0 * at.unit, .trail = 0, .world = &world_of(subject)};
    style.pixels_per_metre =
        scale_to_fit(subject.motion(), at.area({0, 0, width, height}), kStripShare);
    const Ink ink{Typeface::kRegular, 20.0 * at.unit, palette.muted};
    double x = kCardMargin;
    for (const double time : even_times(subject.motion(), kStripPoses)) {
        const Area cell = at.area({x, 962, width, height});
        const Moment moment = moment_of(subject.motion(), time);
        add_moment(canvas, cell, subject, moment, style);
        canvas.round_corners(cell, 10.0 * at.unit, palette.window);
        canvas.add_text(cell.x + 0.5 * cell.width, at.y(1182), fmt::format("{:.1f} s", moment.time),
                        ink, Align::kMiddle);
        x += width + gap;
    }
}

const char* foot_of(const Subject& subject, bool moving) {
    if (moving) return "The creature is inside: drop this picture on Cambrian";
    return subject.environment().dimensions == 3
               ? "The creature is inside: cambrian render makes a clip of it"
               : "The creature is inside: open this picture to see it move";
}

void add_foot(PictureCanvas& canvas, const CardRoom& at, const char* words,
              const Palette& palette) {
    const Ink strong{Typeface::kStrong, 21.0 * at.unit, palette.muted};
    const Ink small{Typeface::kRegular, 21.0 * at.unit, palette.muted};
    canvas.add_text(at.x(kCardMargin), at.y(1242), "Cambrian", strong);
    canvas.add_text(at.x(kCardWidth - kCardMargin), at.y(1242), words, small, Align::kRight);
}

void add_card(PictureCanvas& canvas, const Subject& subject, const Palette& palette,
              const Moment& moment, const char* foot) {
    const CardRoom at(canvas);
    canvas.clear(palette.window);
    const Area portrait = at.area({kCardMargin, kCardMargin, kCardWidth - 2.0 * kCardMargin, 650});
    MomentStyle style{
        .palette = palette, .label_size = 18.0 * at.unit, .trail = 0, .world = &world_of(subject)};
    style.pixels_per_metre = scale_to_fit(subject.motion(), portrait, kPortraitShare);
    add_moment(canvas, portrait, subject, moment, style);
    canvas.round_corners(portrait, 18.0 * at.unit, palette.window);
    add_heading(canvas, at, subject, palette);
    add_facts(canvas, at, subject, palette);
    add_strip(canvas, at, subject, palette);
    add_foot(canvas, at, foot, palette);
}

}  // namespace

void draw_card(PictureCanvas& canvas, const Subject& subject, const Palette& palette) {
    const double time = telling_time(subject.motion());
    add_card(canvas, subject, palette, moment_of(subject.motion(), time), foot_of(subject, false));
}

void draw_moving_card(PictureCanvas& canvas, const Subject& subject, const Palette& palette,
                      const Moment& moment) {
    add_card(canvas, subject, palette, moment, foot_of(subject, true));
}

}  // namespace cambrian
