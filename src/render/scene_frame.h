#pragma once

// What to draw in a frame: shapes and skins. All shapes are rounded boxes: a circle is a box whose
// corner radius is its half extent, a line a thin box. World units are metres, y up.

#include "math/types.h"
#include "render/backdrop.h"
#include "render/color.h"
#include "render/skin.h"
#include "render/space_frame.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace cambrian {

struct Shape {
    Vec2 center = Vec2::Zero();        // m
    Vec2 half_extents = Vec2::Zero();  // m
    double angle = 0.0;                // rad, counter-clockwise
    double radius = 0.0;               // m, of the corners
    double outline_width = 0.0;        // m, inside the edge
    double blur = 0.0;                 // m, width over which the edge fades; 0 means one pixel
    Color fill = {};
    Color outline = {};
};

// In light frames, skins have no gleam and scenery has fewer small things, so that they are
// cheaper.
enum class Detail : unsigned char { kFull, kLight };

struct SceneFrame {
    Color background;  // may be transparent in a framebuffer of its own
    // Covers the background unless it is null. Recipes are told apart by address, so each must stay
    // where it is while frames name it.
    const BackdropRecipe* backdrop = nullptr;
    std::vector<Shape> shapes;        // from back to front
    std::vector<Skin> skins;          // the same; each says how many shapes are behind it
    std::vector<SkinBox> skin_boxes;  // of all skins
    SkinLight light;
    // What is in space, behind all shapes; it fills the view in place of a backdrop. Null for none.
    std::shared_ptr<const SpaceFrame> space;
    Detail detail = Detail::kFull;
    GroundShape ground;

    void add_box(const Vec2& center, const Vec2& half_extents, const Color& fill);
    void add_line(const Vec2& from, const Vec2& to, double width, const Color& color);
    void add_circle(const Vec2& center, double radius, const Color& fill);
    void add_ring(const Vec2& center, double radius, double width, const Color& color);
    // Adds a disc that fades from its centre to nothing at the radius.
    void add_glow(const Vec2& center, double radius, const Color& color);
    // Adds an arc from the first angle to the second (rad).
    void add_arc(const Vec2& center, double radius, const std::array<double, 2>& angles,
                 double width, const Color& color);
    // Adds dots along a path, older ones fainter; the oldest point is first.
    void add_trail(std::span<const Vec2> points, double dot_radius, const Color& color);
    // Adds a skin over the boxes that were added last; its number of boxes is given by it.
    void add_skin(Skin skin);
    void clear();
};

}  // namespace cambrian
