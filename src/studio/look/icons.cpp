#include "studio/look/icons.h"

#include "math/elementary.h"

#include <array>
#include <cstddef>

namespace cambrian {
namespace {

// A drawing of an icon in a square from -1 to 1, with y downwards.
struct Pen {
    ImDrawList& list;
    ImVec2 center;
    float half;
    ImU32 color;
    float width;

    ImVec2 at(float x, float y) const { return {center.x + x * half, center.y + y * half}; }
    void triangle(const ImVec2& a, const ImVec2& b, const ImVec2& c) const {
        list.AddTriangleFilled(a, b, c, color);
    }
    void bar(float x, float y, float x2, float y2) const {
        list.AddRectFilled(at(x, y), at(x2, y2), color, 0.12F * half);
    }
    void line(float x, float y, float x2, float y2) const {
        list.AddLine(at(x, y), at(x2, y2), color, width);
    }
};

void draw_restart(const Pen& pen) {
    constexpr auto quarter = static_cast<float>(kPi) / 2.0F;
    pen.list.PathArcTo(pen.center, 0.75F * pen.half, -0.6F * quarter, 2.6F * quarter, 24);
    pen.list.PathStroke(pen.color, ImDrawFlags_None, pen.width);
    pen.triangle(pen.at(0.12F, -0.62F), pen.at(0.95F, -0.95F), pen.at(0.9F, -0.08F));
}

void draw_follow(const Pen& pen) {
    pen.list.AddCircle(pen.center, 0.6F * pen.half, pen.color, 24, pen.width);
    pen.list.AddCircleFilled(pen.center, 0.2F * pen.half, pen.color, 12);
    pen.line(0.0F, -1.0F, 0.0F, -0.6F);
    pen.line(0.0F, 0.6F, 0.0F, 1.0F);
    pen.line(-1.0F, 0.0F, -0.6F, 0.0F);
    pen.line(0.6F, 0.0F, 1.0F, 0.0F);
}

void draw_fit(const Pen& pen) {
    for (const float sx : {-1.0F, 1.0F}) {
        for (const float sy : {-1.0F, 1.0F}) {
            pen.line(0.85F * sx, 0.85F * sy, 0.3F * sx, 0.85F * sy);
            pen.line(0.85F * sx, 0.85F * sy, 0.85F * sx, 0.3F * sy);
        }
    }
}

void draw_folder(const Pen& pen) {
    pen.list.AddRectFilled(pen.at(-0.9F, -0.7F), pen.at(0.0F, 0.0F), pen.color, 0.2F * pen.half);
    pen.list.AddRectFilled(pen.at(-0.9F, -0.4F), pen.at(0.9F, 0.75F), pen.color, 0.2F * pen.half);
}

void draw_file(const Pen& pen) {
    const std::array<ImVec2, 5> sheet = {pen.at(-0.6F, -0.85F), pen.at(0.15F, -0.85F),
                                         pen.at(0.65F, -0.35F), pen.at(0.65F, 0.85F),
                                         pen.at(-0.6F, 0.85F)};
    pen.list.AddPolyline(sheet.data(), static_cast<int>(sheet.size()), pen.color,
                         ImDrawFlags_Closed, pen.width);
}

void draw_eye(const Pen& pen) {
    constexpr auto eighth = static_cast<float>(kPi) / 4.0F;
    for (const float side : {-1.0F, 1.0F}) {
        const float middle = -2.0F * side * eighth;
        pen.list.PathArcTo(pen.at(0.0F, 0.7F * side), 1.15F * pen.half, middle - 1.05F * eighth,
                           middle + 1.05F * eighth, 16);
        pen.list.PathStroke(pen.color, ImDrawFlags_None, pen.width);
    }
    pen.list.AddCircleFilled(pen.center, 0.28F * pen.half, pen.color, 14);
}

// Draws two boxes, one behind the other.
void draw_ghost(const Pen& pen) {
    pen.list.AddRect(pen.at(-0.9F, -0.8F), pen.at(0.3F, 0.4F), pen.color, 0.25F * pen.half, 0,
                     pen.width);
    pen.list.AddRectFilled(pen.at(-0.3F, -0.2F), pen.at(0.9F, 0.9F), pen.color, 0.25F * pen.half);
}

void draw_pencil(const Pen& pen) {
    pen.triangle(pen.at(-0.9F, 0.55F), pen.at(-0.55F, 0.2F), pen.at(-0.25F, 0.5F));
    const std::array<ImVec2, 4> shaft = {pen.at(-0.45F, 0.1F), pen.at(0.45F, -0.8F),
                                         pen.at(0.8F, -0.45F), pen.at(-0.12F, 0.43F)};
    pen.list.AddConvexPolyFilled(shaft.data(), static_cast<int>(shaft.size()), pen.color);
    pen.line(-0.95F, 0.9F, 0.95F, 0.9F);
}

// Draws a body on two legs.
void draw_little_body(const Pen& pen) {
    pen.list.AddRectFilled(pen.at(-0.8F, -0.75F), pen.at(0.8F, -0.05F), pen.color,
                           0.25F * pen.half);
    for (const float side : {-1.0F, 1.0F}) {
        pen.line(0.5F * side, -0.1F, 0.8F * side, 0.45F);
        pen.line(0.8F * side, 0.45F, 0.55F * side, 0.95F);
        pen.list.AddCircleFilled(pen.at(0.8F * side, 0.45F), 1.2F * pen.width, pen.color, 10);
    }
}

void draw_question(const Pen& pen) {
    constexpr auto quarter = static_cast<float>(kPi) / 2.0F;
    pen.list.PathArcTo(pen.at(0.0F, -0.4F), 0.45F * pen.half, -2.1F * quarter, 1.0F * quarter, 16);
    pen.list.PathLineTo(pen.at(0.0F, 0.35F));
    pen.list.PathStroke(pen.color, ImDrawFlags_None, 1.25F * pen.width);
    pen.list.AddCircleFilled(pen.at(0.0F, 0.78F), 1.0F * pen.width, pen.color, 10);
}

// Returns the ten corners of a star; the outer ones lie on a circle.
std::array<ImVec2, 10> star_corners(const Pen& pen) {
    std::array<ImVec2, 10> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double angle = kPi * (0.2 * static_cast<double>(i) - 0.5);
        const float radius = i % 2 == 0 ? 1.0F : 0.45F;
        corners[i] = pen.at(radius * static_cast<float>(cosine(angle)),
                            radius * static_cast<float>(sine(angle)));
    }
    return corners;
}

void draw_star(const Pen& pen) {
    const auto corners = star_corners(pen);
    for (std::size_t i = 0; i < corners.size(); i += 2) {
        const ImVec2& before = corners[(i + corners.size() - 1) % corners.size()];
        pen.triangle(before, corners[i], corners[i + 1]);
        pen.triangle(before, corners[i + 1], pen.center);
    }
}

void draw_star_outline(const Pen& pen) {
    const auto corners = star_corners(pen);
    pen.list.AddPolyline(corners.data(), static_cast<int>(corners.size()), pen.color,
                         ImDrawFlags_Closed, pen.width);
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): a list of shapes
void draw_icon(ImDrawList& list, Icon icon, const ImVec2& center, float size, const Color& color) {
    const Pen pen{list, center, 0.5F * size, pack(color), size / 9.0F};
    switch (icon) {
        case Icon::kNone:
            break;
        case Icon::kPlay:
            pen.triangle(pen.at(-0.6F, -0.85F), pen.at(0.9F, 0.0F), pen.at(-0.6F, 0.85F));
            break;
        case Icon::kPause:
            pen.bar(-0.7F, -0.8F, -0.2F, 0.8F);
            pen.bar(0.2F, -0.8F, 0.7F, 0.8F);
            break;
        case Icon::kStep:
            pen.triangle(pen.at(-0.75F, -0.8F), pen.at(0.4F, 0.0F), pen.at(-0.75F, 0.8F));
            pen.bar(0.5F, -0.8F, 0.85F, 0.8F);
            break;
        case Icon::kStepBack:
            pen.triangle(pen.at(0.75F, -0.8F), pen.at(-0.4F, 0.0F), pen.at(0.75F, 0.8F));
            pen.bar(-0.85F, -0.8F, -0.5F, 0.8F);
            break;
        case Icon::kRestart:
            draw_restart(pen);
            break;
        case Icon::kFollow:
            draw_follow(pen);
            break;
        case Icon::kFit:
            draw_fit(pen);
            break;
        case Icon::kChevronDown:
            pen.line(-0.6F, -0.3F, 0.0F, 0.35F);
            pen.line(0.0F, 0.35F, 0.6F, -0.3F);
            break;
        case Icon::kChevronRight:
            pen.line(-0.3F, -0.6F, 0.35F, 0.0F);
            pen.line(0.35F, 0.0F, -0.3F, 0.6F);
            break;
        case Icon::kChevronLeft:
            pen.line(0.3F, -0.6F, -0.35F, 0.0F);
            pen.line(-0.35F, 0.0F, 0.3F, 0.6F);
            break;
        case Icon::kClose:
            pen.line(-0.6F, -0.6F, 0.6F, 0.6F);
            pen.line(-0.6F, 0.6F, 0.6F, -0.6F);
            break;
        case Icon::kFolder:
            draw_folder(pen);
            break;
        case Icon::kFile:
            draw_file(pen);
            break;
        case Icon::kUp:
            pen.line(-0.6F, 0.0F, 0.0F, -0.7F);
            pen.line(0.0F, -0.7F, 0.6F, 0.0F);
            pen.line(0.0F, -0.7F, 0.0F, 0.8F);
            break;
        case Icon::kEye:
            draw_eye(pen);
            break;
        case Icon::kGhost:
            draw_ghost(pen);
            break;
        case Icon::kPencil:
            draw_pencil(pen);
            break;
        case Icon::kBody:
            draw_little_body(pen);
            break;
        case Icon::kHelp:
            draw_question(pen);
            break;
        case Icon::kSearch:
            pen.list.AddCircle(pen.at(-0.2F, -0.2F), 0.55F * pen.half, pen.color, 20, pen.width);
            pen.line(0.22F, 0.22F, 0.8F, 0.8F);
            break;
        case Icon::kStar:
            draw_star(pen);
            break;
        case Icon::kStarOutline:
            draw_star_outline(pen);
            break;
    }
}

}  // namespace cambrian
