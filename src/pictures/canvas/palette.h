#pragma once

// The colours of the window and of pictures.

#include "render/color.h"

namespace cambrian {

enum class ThemeKind : unsigned char { kDark, kLight };

struct Palette {
    Color window;  // behind and between panels
    Color panel;
    Color raised;   // controls
    Color hovered;  // controls under the mouse
    Color overlay;  // menus and cards over the panels
    Color border;
    Color text;
    Color muted;  // labels, units
    Color faint;  // marks of least importance
    Color accent;
    Color on_accent;  // text on the accent colour
    Color danger;
    Color sky;  // background of the viewport
    Color ground;
    Color ground_line;
    // Colours of the colour-blind-safe set of Okabe & Ito.
    Color plot_best;
    Color plot_median;
};

Palette palette_of(ThemeKind kind);

}  // namespace cambrian
