#pragma once

#include "core/result.h"
#include "pictures/canvas/easel.h"
#include "render/opengl/offscreen_context.h"

#include <memory>
#include <optional>

namespace cambrian {

// All that drawing one size of picture needs without a window, in the order in which it comes and
// goes.
struct Workshop {
    std::unique_ptr<OffscreenContext> context;
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<Lettering> lettering;
    std::optional<Easel> easel;
};

// Of pictures so many pixels wide and high.
Result<std::unique_ptr<Workshop>> open_workshop(int width, int height);

}  // namespace cambrian
