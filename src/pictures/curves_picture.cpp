#include "pictures/curves_picture.h"

#include "core/text/pretty_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

// The layout is made for a picture of this height and scaled to the requested one.
constexpr double kCurvesHeight = 900.0;  // pixels
constexpr double kCurvesMargin = 40.0;
constexpr double kCurvesHeader = 150.0;  // height of the title and the line below it
constexpr double kLeft = 120.0;          // left end of the horizontal axis
constexpr double kBottom = 96.0;
constexpr double kLegend = 40.0;           // height of a line of the legend
constexpr std::size_t kOneColumn = 4;      // most curves whose names fit in one column
constexpr std::size_t kLegendColumns = 3;  // columns of the legend for more curves
constexpr int kMostTicks = 6;
constexpr float kBandShade = 0.22F;

// The colour-blind-safe set of Okabe & Ito, without black.
constexpr std::array<unsigned, 7> kColors = {0xE69F00, 0x56B4E9, 0x009E73, 0xCC79A7,
                                             0xD55E00, 0x0072B2, 0xF0E442};

// Returns a round interval between the ticks of an axis from 0 to `most`: 1, 2 or 5 times a power
// of ten.
double tick_step(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most / kMostTicks)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (most / (step * power) <= kMostTicks) return step * power;
    }
    return 10.0 * power;
}

double greatest(const std::vector<BandedCurve>& curves, std::vector<double> BandedCurve::*values) {
    double most = 0.0;
    for (const BandedCurve& curve : curves) {
        for (const double value : curve.*values)
            most = std::max(most, value);
    }
    return most > 0.0 ? most : 1.0;
}

class Plot {
public:
    Plot(PictureCanvas& canvas, const std::vector<BandedCurve>& curves, const Palette& palette)
        : canvas_(canvas),
          curves_(curves),
          palette_(palette),
          unit_(canvas.height() / kCurvesHeight),
          width_(greatest(curves, &BandedCurve::x)),
          height_(greatest(curves, &BandedCurve::upper)) {
        columns_ = curves.size() > kOneColumn ? kLegendColumns : 1;
        const std::size_t rows = (curves.size() + columns_ - 1) / columns_;
        const double legend = kLegend * unit_ * static_cast<double>(rows);
        const double top = kCurvesHeader * unit_;
        area_ = {kLeft * unit_, top, canvas.width() - (kLeft + kCurvesMargin) * unit_,
                 canvas.height() - top - kBottom * unit_ - legend};
    }

    void draw(const CurvesLabels& labels) {
        canvas_.clear(palette_.window);
        add_words(labels);
        add_axes(labels);
        for (std::size_t i = 0; i < curves_.size(); ++i)
            add_band(curves_[i], color_of_curve(i));
        for (std::size_t i = 0; i < curves_.size(); ++i)
            add_middle(curves_[i], color_of_curve(i));
        add_legend();
    }

private:
    Vec2 at(double x, double y) const {
        return {area_.x + area_.width * x / width_, area_.bottom() - area_.height * y / height_};
    }

    void add_words(const CurvesLabels& labels) {
        const double left = kCurvesMargin * unit_;
        canvas_.add_text(left, 62.0 * unit_, labels.title,
                         {Typeface::kStrong, 38.0 * unit_, palette_.text}, Align::kLeft,
                         canvas_.width() - 2.0 * left);
        canvas_.add_text(left, 98.0 * unit_, labels.below,
                         {Typeface::kRegular, 22.0 * unit_, palette_.muted}, Align::kLeft,
                         canvas_.width() - 2.0 * left);
        canvas_.add_text(left, 138.0 * unit_, labels.y, small());
    }

    Ink small() const { return {Typeface::kRegular, 20.0 * unit_, palette_.muted}; }

    void add_axes(const CurvesLabels& labels) {
        canvas_.add_box(area_, 0.0, palette_.panel);
        const double step_y = tick_step(height_);
        for (double y = 0.0; y <= height_; y += step_y) {
            canvas_.add_line(at(0.0, y), at(width_, y), unit_, palette_.border);
            canvas_.add_text(area_.x - 12.0 * unit_, at(0.0, y).y() + 7.0 * unit_, pretty_number(y),
                             small(), Align::kRight);
        }
        const double step_x = tick_step(width_);
        for (double x = 0.0; x <= width_; x += step_x) {
            canvas_.add_text(at(x, 0.0).x(), area_.bottom() + 30.0 * unit_, pretty_number(x),
                             small(), Align::kMiddle);
        }
        canvas_.add_text(area_.right(), area_.bottom() + 62.0 * unit_, labels.x, small(),
                         Align::kRight);
    }

    // Fills one column of pixels at a time between the two edges.
    void add_band(const BandedCurve& curve, const Color& color) {
        for (std::size_t i = 1; i < curve.x.size(); ++i) {
            const double from = std::floor(at(curve.x[i - 1], 0.0).x());
            const double to = std::floor(at(curve.x[i], 0.0).x());
            for (double x = from; x < to; x += 1.0) {
                const double share = (x + 0.5 - from) / (to - from);
                const double low = std::lerp(curve.lower[i - 1], curve.lower[i], share);
                const double high = std::lerp(curve.upper[i - 1], curve.upper[i], share);
                const double top = at(0.0, high).y();
                canvas_.add_box({x, top, 1.0, at(0.0, low).y() - top}, 0.0,
                                with_alpha(color, kBandShade));
            }
        }
    }

    void add_middle(const BandedCurve& curve, const Color& color) {
        for (std::size_t i = 1; i < curve.x.size(); ++i) {
            canvas_.add_line(at(curve.x[i - 1], curve.middle[i - 1]),
                             at(curve.x[i], curve.middle[i]), 3.0 * unit_, color);
        }
    }

    void add_legend() {
        const double width = area_.width / static_cast<double>(columns_);
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            const double x = area_.x + width * static_cast<double>(i % columns_);
            const std::size_t line = i / columns_;
            const double y =
                area_.bottom() + unit_ * (kBottom + kLegend * static_cast<double>(line));
            canvas_.add_line({x, y}, {x + 36.0 * unit_, y}, 5.0 * unit_, color_of_curve(i));
            canvas_.add_text(x + 52.0 * unit_, y + 7.0 * unit_, curves_[i].name,
                             {Typeface::kRegular, 22.0 * unit_, palette_.text}, Align::kLeft,
                             width - 60.0 * unit_);
        }
    }

    PictureCanvas& canvas_;
    const std::vector<BandedCurve>& curves_;
    const Palette& palette_;
    double unit_;
    double width_;  // width of the axes, in the curves' units
    double height_;
    std::size_t columns_ = 1;  // columns of the legend
    Area area_;
};

}  // namespace

Color color_of_curve(std::size_t curve) {
    return color_of(kColors[curve % kColors.size()]);
}

void draw_curves(PictureCanvas& canvas, const std::vector<BandedCurve>& curves,
                 const CurvesLabels& labels, const Palette& palette) {
    Plot(canvas, curves, palette).draw(labels);
}

}  // namespace cambrian
