#pragma once

#include "studio/frame/frame_context.h"
#include "studio/look/ui_context.h"

#include <memory>
#include <span>

namespace cambrian {

class Renderer;

// A part of the window. It sees const data, answers with requests, and is drawn inside a window of
// its own.
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

// What a card may be placed by.
struct CardSpace {
    Rect window;
    Rect viewport;
};

// Lengths are in units of 1/96 inch.
struct PanelPlace {
    PanelArea area = PanelArea::kCard;
    float padding_x = -1.0F;  // negative: the style's
    float padding_y = -1.0F;
    Place keyboard = Place::kNone;  // the place of the window that is this panel
    float rounding = 10.0F;         // of a card
    // The card's rectangle in this frame; null for other areas.
    Rect (*card)(const FrameContext& frame, const CardSpace& space) = nullptr;
};

struct PanelKind {
    const char* name;  // of its window, as tests and the tour know it
    PanelPlace place;
    bool (*shown)(const FrameContext& frame);
    // Without a renderer (tests) everything but the picture works.
    std::unique_ptr<Panel> (*make)(Renderer* renderer);
};

}  // namespace cambrian
