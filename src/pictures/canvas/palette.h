#pragma once

// The one visual language's colours, in the window and in pictures.

#include "render/color.h"

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

Palette palette_of(ThemeKind kind);

}  // namespace cambrian
