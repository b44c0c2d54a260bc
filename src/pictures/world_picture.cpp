#include "pictures/world_picture.h"

#include "core/text/counted.h"
#include "pictures/clip.h"
#include "pictures/preserve/world_scene.h"
#include "preserve/world_time.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kHeadHeight = 48.0;   // pixels at scale 1; height of the line above the world
constexpr double kWorldMargin = 12.0;  // pixels at scale 1, around the world

}  // namespace

void draw_world_frame(PictureCanvas& canvas, const Palette& palette, const PreservePicture& picture,
                      const std::string& name) {
    const double unit = layout_unit(canvas);
    const double head = std::min(kHeadHeight * unit, 0.25 * canvas.height());
    const Area room = {0.0, head, static_cast<double>(canvas.width()), canvas.height() - head};
    const Area world =
        room.inset(std::min(kWorldMargin * unit, 0.1 * std::min(room.width, room.height)));
    Camera camera;
    camera.pixels_per_metre =
        std::min(world.width / picture.area.width, world.height / picture.area.height);
    camera.center = middle_of_view(picture.area, room.height * camera.pixel());
    SceneFrame frame;
    WorldMarks marks;
    marks.scenery = Daytime::kNoon;
    add_world(frame, palette, camera, {room.width, room.height}, picture, marks);
    canvas.clear(palette.window);
    canvas.add_scene(std::move(frame), camera, room);
    const double left = 16.0 * unit;
    const double right = canvas.width() - left;
    const double baseline = 0.68 * head;
    const std::string words = counted(picture.now.population, "creature") + "  ·  " +
                              counted(picture.now.lineages, "lineage") + "  ·  " +
                              world_time(picture.tick);
    const double half = 0.5 * (right - left);
    canvas.add_text(left, baseline, name, {Typeface::kStrong, 24.0 * unit, palette.text},
                    Align::kLeft, 0.9 * half);
    canvas.add_text(right, baseline, words, {Typeface::kRegular, 19.0 * unit, palette.muted},
                    Align::kRight, 1.1 * half);
}

}  // namespace cambrian
