#include "pictures/sheet.h"

#include "core/text/pretty_text.h"
#include "pictures/scene/moment.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// The layout is made for a sheet of this size and scaled to the requested one.
constexpr double kSheetWidth = 1600.0;  // pixels
constexpr double kSheetHeight = 900.0;
constexpr double kSheetMargin = 36.0;
constexpr double kSheetHeader = 104.0;
constexpr double kGap = 14.0;
constexpr double kCaption = 30.0;     // height of the text below each pose
constexpr double kBestAspect = 1.35;  // preferred width over height of a pose
constexpr double kPoseShare = 0.7;    // share of a pose's cell that the creature fills

struct Grid {
    int columns = 1;
    int rows = 1;
};

// Chooses the division into cells that is nearest to the preferred aspect and has few empty cells.
Grid choose_grid(int poses, const Area& room, double gap, double caption) {
    Grid best;
    double least = 1e9;
    for (int columns = 1; columns <= poses; ++columns) {
        const int rows = (poses + columns - 1) / columns;
        const double width = (room.width + gap) / columns - gap;
        const double height = (room.height + gap) / rows - gap - caption;
        if (width < 1.0 || height < 1.0) continue;
        const double misfit =
            std::fabs(std::log(width / height / kBestAspect)) + 0.25 * (columns * rows - poses);
        if (misfit < least) {
            least = misfit;
            best = {columns, rows};
        }
    }
    return best;
}

void add_header(PictureCanvas& canvas, const Subject& subject, const Palette& palette,
                double unit) {
    const double left = kSheetMargin * unit;
    const double right = canvas.width() - left;
    const Ink title{Typeface::kStrong, 38.0 * unit, palette.text};
    const Ink score{Typeface::kStrong, 38.0 * unit, palette.accent};
    const Ink small{Typeface::kRegular, 21.0 * unit, palette.muted};
    const double score_width =
        canvas.text_rasterizer().width(subject.fitness, score.typeface, score.size);
    canvas.add_text(left, 62.0 * unit, subject.name, title, Align::kLeft,
                    right - left - score_width - 40.0 * unit);
    canvas.add_text(left, 96.0 * unit, facts_line(subject), small);
    canvas.add_text(right, 62.0 * unit, subject.fitness, score, Align::kRight);
    canvas.add_text(right, 96.0 * unit, subject.goal, small, Align::kRight);
}

}  // namespace

void draw_sheet(PictureCanvas& canvas, const Subject& subject, const Palette& palette, int poses) {
    const double unit = std::min(canvas.width() / kSheetWidth, canvas.height() / kSheetHeight);
    canvas.clear(palette.window);
    add_header(canvas, subject, palette, unit);
    const Area room = {kSheetMargin * unit, (kSheetHeader + kGap) * unit,
                       canvas.width() - 2.0 * kSheetMargin * unit,
                       canvas.height() - (kSheetHeader + 2.0 * kGap) * unit};
    const double gap = kGap * unit;
    const double caption = kCaption * unit;
    const Grid grid = choose_grid(poses, room, gap, caption);
    const double width = (room.width + gap) / grid.columns - gap;
    const double height = (room.height + gap) / grid.rows - gap - caption;
    MomentStyle style{.palette = palette, .label_size = 15.0 * unit};
    style.pixels_per_metre = scale_to_fit(subject.motion(), {0, 0, width, height}, kPoseShare);
    const Ink ink{Typeface::kRegular, 19.0 * unit, palette.muted};
    int index = 0;
    for (const double time : even_times(subject.motion(), poses)) {
        const int row = index / grid.columns;
        const Area cell = {std::round(room.x + index % grid.columns * (width + gap)),
                           std::round(room.y + row * (height + gap + caption)), std::round(width),
                           std::round(height)};
        const Moment moment = moment_of(subject.motion(), time);
        add_moment(canvas, cell, subject, moment, style);
        canvas.round_corners(cell, 8.0 * unit, palette.window);
        canvas.add_text(cell.x + 0.5 * width, cell.bottom() + 22.0 * unit,
                        fmt::format("{:.1f} s", moment.time), ink, Align::kMiddle);
        ++index;
    }
}

}  // namespace cambrian
