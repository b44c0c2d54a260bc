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
    Rect foot;        // an optional line along the bottom
};

// Whether a window has no room for both side panels beside the viewport.
bool is_narrow(float width, float scale);

// Divides the window among the panels. Hidden panels get no width. In small windows panels shrink
// so that the viewport keeps enough room, and in narrow ones the left panel hides the right one.
Layout divide_window(float width, float height, const ViewState& view, float scale,
                     bool with_foot = false);

// Returns the layout in which only the viewport and its transport bar fill the window.
Layout viewer_layout(float width, float height, float scale);

// Resizes panels when the gaps between them are dragged; returns true if the view changed.
bool drag_gaps(const Layout& layout, ViewState& view);

// Draws the gaps between the panels.
void draw_gaps(const Layout& layout);

// Begins the ImGui window of a panel, which ends at end_place(). A negative padding means the
// style's. The window's framebuffer is already cleared with the panels' colour, so no panel paints
// its background. This saves time on software renderers.
void begin_place(const char* name, const Rect& rect, float padding_x = -1.0F,
                 float padding_y = -1.0F);
void end_place();

}  // namespace cambrian
