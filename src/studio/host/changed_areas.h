#pragma once

// Finds the parts of the window that differ from the frame before, so that only they are painted.
// Most panels do not change while a creature moves.

#include "studio/look/ui_context.h"

#include <vector>

namespace cambrian {

class ChangedAreas {
public:
    // Compares the draw data with that of the last call. Returns disjoint areas, aligned to pixels,
    // that must be painted. The result is the full window at first, and after a change of its size,
    // the background or the order of the draw lists. A draw list with a callback always counts as
    // changed, and lies entirely inside an area or outside all of them.
    std::vector<Rect> update(const ImDrawData& data, ImU32 background);

private:
    struct Painted {
        const ImDrawList* list = nullptr;
        Rect area;
        bool calls_back = false;
        ImVector<ImDrawVert> vertices;
        ImVector<ImDrawIdx> indices;
        ImVector<ImDrawCmd> commands;
    };
    static Painted painted(const ImDrawList& list, const Rect& window);
    static bool same(const Painted& painted, const ImDrawList& list);
    std::vector<Rect> changed_lists(const ImDrawData& data);

    std::vector<Painted> painted_;  // draw lists of the last frame, from back to front
    Rect window_;
    ImU32 background_ = 0;
};

}  // namespace cambrian
