#pragma once

#include "studio/frame/frame_context.h"
#include "studio/look/ui_context.h"

#include <memory>
#include <span>

namespace cambrian {

class Renderer;

// A part of the window. A panel sees const data, answers with requests, and is drawn in a Dear
// ImGui window of its own.
class Panel {
public:
    virtual ~Panel() = default;
    virtual void draw(const FrameContext& frame, Requests& out) = 0;
};

// The areas into which the layout divides the window; cards lie over all others.
enum class PanelArea : unsigned char {
    kBar,
    kLeft,
    kCenter,
    kUnderCenter,
    kRight,
    kBottomLeft,
    kBottomRight,
    kUnderAll,
    kCard
};

// The rectangles relative to which a card may be placed.
struct CardSpace {
    Rect window;
    Rect viewport;
};

// Lengths are in units of 1/96 inch.
struct PanelPlace {
    PanelArea area = PanelArea::kCard;
    float padding_x = -1.0F;  // negative: the style's
    float padding_y = -1.0F;
    Place keyboard = Place::kNone;  // the value of Place that names this panel
    float rounding = 10.0F;         // corner radius of a card
    // The card's rectangle in this frame; null for other areas.
    Rect (*card)(const FrameContext& frame, const CardSpace& space) = nullptr;
};

struct PanelKind {
    const char* name;  // the name of its window, which tests and the tour use
    PanelPlace place;
    bool (*shown)(const FrameContext& frame);
    // Without a renderer, as in tests, the panel works but draws no scene.
    std::unique_ptr<Panel> (*make)(Renderer* renderer);
};

}  // namespace cambrian
