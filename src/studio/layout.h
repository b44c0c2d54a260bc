#pragma once

// The layout of the panels in the window.

#include "studio/look/ui_context.h"
#include "studio/look/view_state.h"

namespace cambrian {

struct Layout {
    Rect bar;         // evolve bar, along the top
    Rect experiment;  // left
    Rect viewport;    // centre
    Rect transport;   // under the viewport
    Rect inspector;   // right
    Rect timeline;    // bottom left
    Rect population;  // bottom right
    Rect foot;        // one line along the bottom, if it is wanted
};

// Hidden panels get no width. Sizes shrink with small windows so that the viewport keeps room.
Layout divide_window(float width, float height, const ViewState& view, float scale,
                     bool with_foot = false);

// The layout in which the viewport and its transport fill the window.
Layout viewer_layout(float width, float height, float scale);

// Lets the gaps between panels be dragged; true if the view was changed.
bool drag_gaps(const Layout& layout, ViewState& view);

// Draws the gaps between the panels.
void draw_gaps(const Layout& layout);

// Opens the window of a place; everything until end_place() is inside. Negative padding is the
// style's. The window's framebuffer already has the panels' colour, so that no panel paints its
// background: on software renderers, every pixel counts.
void begin_place(const char* name, const Rect& rect, float padding_x = -1.0F,
                 float padding_y = -1.0F);
void end_place();

}  // namespace cambrian
