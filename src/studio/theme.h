#pragma once

// The one visual language: colours, fonts and sizes. Sizes are given in units of 1/96 inch and
// scaled by the display.

#include "render/color.h"

#include <imgui.h>

#include <string>

namespace cambrian {

enum class ThemeKind : unsigned char { kDark, kLight };

struct Palette {
    Color window;  // behind and between panels
    Color panel;
    Color raised;   // controls
    Color hovered;  // controls under the mouse
    Color overlay;  // menus, and windows that lie over the panels
    Color border;
    Color text;
    Color muted;  // labels, units
    Color faint;  // marks that should not be read first
    Color accent;
    Color on_accent;  // text on the accent
    Color danger;
    Color sky;  // viewport
    Color ground;
    Color ground_line;
    // Okabe & Ito's colour-blind-safe set.
    Color plot_best;
    Color plot_median;
};

struct Fonts {
    ImFont* body = nullptr;    // 15
    ImFont* small = nullptr;   // 13
    ImFont* strong = nullptr;  // 15, semi-bold
    ImFont* title = nullptr;   // 20, semi-bold
    ImFont* mono = nullptr;    // 14, for what is typed
};

Palette palette_of(ThemeKind kind);

// Colours and spacing of Dear ImGui's own controls.
void apply_style(const Palette& palette, float scale);

// Adds the studio's typeface (Inter, or what is installed) to the font atlas.
Fonts load_fonts(float scale);

}  // namespace cambrian
