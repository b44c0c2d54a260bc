#pragma once

// Which parts of the window look different from the frame before, so that only they are painted:
// most panels stand still while one creature moves.

#include "studio/look/ui_context.h"

#include <vector>

namespace cambrian {

class ChangedAreas {
public:
    // Of what is about to be painted, compared with what the last call was given: areas of whole
    // pixels, apart from each other. All of the window at first, and after a change of its size,
    // of what is painted under everything, or of the order of the lists. A list that calls back
    // counts as changed always, and lies within an area or outside of all.
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

    std::vector<Painted> painted_;  // from back to front
    Rect window_;
    ImU32 background_ = 0;
};

}  // namespace cambrian
