#include "app/evolve/comparison_pictures.h"

#include "comparison/curves.h"
#include "comparison/report.h"
#include "core/files/file_io.h"
#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "persist/creature/png_file.h"
#include "pictures/curves_picture.h"
#include "pictures/workshop.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {
namespace {

constexpr int kWidth = 1600;  // pixels
constexpr int kHeight = 900;
constexpr int kPoints = 200;  // points per curve

std::vector<BandedCurve> curves_of(const std::vector<ComparedRun>& runs, const std::string& world) {
    std::vector<BandedCurve> curves;
    for (const std::string& arm : arms_of(runs)) {
        const std::vector<ComparedRun> some = runs_of(runs, world, arm);
        if (some.empty()) continue;
        CurveBand band = band_of(some, kPoints);
        const std::string count = counted(some.size(), "run");
        curves.push_back({fmt::format("{}, {}", arm, count), std::move(band.trials),
                          std::move(band.lower), std::move(band.middle), std::move(band.upper)});
    }
    return curves;
}

}  // namespace

Status save_comparison_pictures(const std::filesystem::path& folder,
                                const std::vector<ComparedRun>& runs) {
    const auto workshop = open_workshop(kWidth, kHeight);
    if (!workshop) return workshop.error();
    PictureCanvas& canvas = *(*workshop)->canvas;
    for (const std::string& world : worlds_of(runs)) {
        draw_curves(canvas, curves_of(runs, world),
                    {.title = capitalized(world),
                     .below = "Best creature of a run: median and middle half of the seeds",
                     .x = "trials",
                     .y = "score"},
                    palette_of(ThemeKind::kLight));
        const Result<std::string> png = encode_png(canvas.finish());
        if (!png) return png.error();
        Status written = write_file(folder / fmt::format("curves-{}.png", world), *png);
        if (!written) return written;
    }
    return {};
}

}  // namespace cambrian
