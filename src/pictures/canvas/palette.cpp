#include "pictures/canvas/palette.h"

namespace cambrian {

Palette palette_of(ThemeKind kind) {
    Palette p;
    const bool dark = kind == ThemeKind::kDark;
    const auto choose = [dark](unsigned dark_rgb, unsigned light_rgb) {
        return color_of(dark ? dark_rgb : light_rgb);
    };
    p.window = choose(0x0F1216, 0xD9DDE2);
    p.panel = choose(0x171B21, 0xF4F5F7);
    p.raised = choose(0x242A33, 0xE3E6EB);
    p.hovered = choose(0x303844, 0xD5DAE1);
    p.overlay = choose(0x1E242C, 0xFDFDFE);
    p.border = choose(0x2A313B, 0xCDD2D9);
    p.text = choose(0xE6EAEF, 0x1C2127);
    p.muted = choose(0x98A3B1, 0x5A6573);
    p.faint = choose(0x566170, 0x98A2AE);
    p.accent = choose(0x45B8A4, 0x12806F);
    p.on_accent = choose(0x06231E, 0xFFFFFF);
    p.danger = choose(0xE8806A, 0xB23A22);
    p.sky = choose(0x12161B, 0xEBEEF2);
    p.ground = choose(0x1D232B, 0xD4D9DF);
    p.ground_line = choose(0x5B6878, 0x7F8A97);
    p.plot_best = choose(0xE69F00, 0xB87A00);
    p.plot_median = choose(0x56B4E9, 0x0072B2);
    return p;
}

}  // namespace cambrian
