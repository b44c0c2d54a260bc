#pragma once

#include "render/color.h"

#include <imgui.h>

namespace cambrian {

enum class Icon : unsigned char {
    kNone,
    kPlay,
    kPause,
    kStep,
    kStepBack,
    kRestart,
    kFollow,
    kFit,
    kChevronDown,
    kChevronRight,
    kChevronLeft,
    kClose,
    kFolder,
    kFile,
    kUp,
    kEye,
    kGhost,
    kPencil,
    kBody,
    kHelp,
    kSearch,
    kStar,
    kStarOutline,
};

// Draws an icon from lines and shapes, centred, `size` pixels across.
void draw_icon(ImDrawList& list, Icon icon, const ImVec2& center, float size, const Color& color);

}  // namespace cambrian
