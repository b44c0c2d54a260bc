#pragma once

// The state that all controls share besides Dear ImGui's: theme, scale and positions of controls.
// ImGui's io.UserData points to it, so that drawing code needs no global variable.

#include "core/image.h"
#include "pictures/scene/character.h"
#include "render/camera.h"
#include "studio/look/foreign_letters.h"
#include "studio/look/theme.h"

#include <imgui.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct ImGuiWindow;

namespace cambrian {

struct Rect {
    float x = 0.0F;
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;

    ImVec2 low() const { return {x, y}; }
    ImVec2 high() const { return {x + width, y + height}; }
    ImVec2 center() const { return {x + 0.5F * width, y + 0.5F * height}; }
    bool contains(const ImVec2& point) const {
        return point.x >= x && point.x < x + width && point.y >= y && point.y < y + height;
    }
    friend bool operator==(const Rect&, const Rect&) = default;
};

// The position at which a named control was drawn last, in window pixels.
struct NotedPlace {
    Rect rect;
    Rect seen;                // visible part; empty if it is scrolled out of sight
    bool cut = false;         // partly outside a window that cannot be scrolled
    const char* window = "";  // name of its panel or popup
    int frame = 0;            // number of the frame in which it was drawn
};

// The text that is being typed into a slider.
struct TypedText {
    ImGuiID slider = 0;
    std::string text;
    bool changed = false;  // differs from the slider's value as shown
};

// The control that the keyboard has reached with Tab (widgets/keyboard_focus.h).
struct KeyboardFocus {
    ImGuiID control = 0;                 // 0 for none
    bool text = false;                   // it is a text field
    bool arrived = false;                // it was reached in this frame
    std::vector<ImGuiID> stops;          // the controls of this frame so far, in the order drawn
    const ImGuiWindow* layer = nullptr;  // the window whose controls alone count; null for all
};

// A moment of a body's motion.
struct TileMoment {
    std::span<const Pose> poses;
    std::span<const double> stretches;
    Character character;
    Camera camera;
    Vec3 middle = Vec3::Zero();  // m; in space, in the middle of the picture
};
// A body as a small picture, at rest unless there is a moment.
struct TileWish {
    const Phenotype& phenotype;
    double hue = 0.0;        // turns
    std::uint64_t line = 0;  // of its founder
    int width = 1;           // pixels
    int height = 1;
    const TileMoment* moment = nullptr;
};
// The picture's place: a texture and the corners of its part of it, the upper left one first.
struct TilePicture {
    ImTextureID texture = nullptr;
    ImVec2 from;
    ImVec2 to;
};

struct UiContext {
    LookMode look = LookMode::kLife;  // of creatures on tiles
    ThemeKind theme = ThemeKind::kDark;
    Palette palette = palette_of(ThemeKind::kDark);
    Fonts fonts;
    ForeignLetters letters;
    float scale = 1.0F;
    // By name; read by tests, the tour and the status log.
    std::map<std::string, NotedPlace> places;
    // The item under the mouse and the time since when (s), for the delay of tooltips.
    ImVec2 hovered = {-1.0F, -1.0F};
    double hovered_since = 0.0;
    std::optional<TypedText> typed;
    KeyboardFocus focus;
    // Why the last text typed into a control was refused; empty if none was.
    std::string complaint;
    // Returns a picture's texture; empty where nothing is painted.
    std::function<ImTextureID(const std::shared_ptr<const Image>&)> texture_of;
    // Returns the picture of a living body; empty where nothing is painted.
    std::function<std::optional<TilePicture>(const TileWish&)> tile_of;
};

UiContext& ui();

// Converts units of 1/96 inch to pixels.
inline float px(float units) {
    return units * ui().scale;
}
inline const Palette& colors() {
    return ui().palette;
}
inline ImU32 paint(const Color& color) {
    return pack(color);
}
// Must be told of texts of files and of the user, so that letters of other scripts are loaded.
inline void note_letters(std::string_view text) {
    ui().letters.note(text, *ui().fonts.body);
}
// Records the position of the item just drawn, or of a part of the window being drawn.
void note_place(const std::string& name);
void note_place(const std::string& name, const Rect& rect);
// Returns whether the window, or one that contains it, can be scrolled vertically.
bool scrolls_down(const ImGuiWindow* window);

// Sets a font or text colour for a scope.
class WithFont {
public:
    explicit WithFont(ImFont* font) { ImGui::PushFont(font); }
    ~WithFont() { ImGui::PopFont(); }
    WithFont(const WithFont&) = delete;
    WithFont& operator=(const WithFont&) = delete;
};
class WithTextColor {
public:
    explicit WithTextColor(const Color& color) {
        ImGui::PushStyleColor(ImGuiCol_Text, paint(color));
    }
    ~WithTextColor() { ImGui::PopStyleColor(); }
    WithTextColor(const WithTextColor&) = delete;
    WithTextColor& operator=(const WithTextColor&) = delete;
};

}  // namespace cambrian
