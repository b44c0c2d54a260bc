#include "studio/host/area_painting.h"

#include "render/opengl/gl.h"

#include <algorithm>
#include <backends/imgui_impl_opengl3.h>
#include <deque>
#include <vector>

namespace cambrian {
namespace {

ImVec4 common(const ImVec4& clip, const Rect& area) {
    const ImVec2 low = {std::max(clip.x, area.x), std::max(clip.y, area.y)};
    return {low.x, low.y, std::max(low.x, std::min(clip.z, area.high().x)),
            std::max(low.y, std::min(clip.w, area.high().y))};
}

// Restricts a draw list to an area for the lifetime of this object.
class Clipped {
public:
    Clipped(ImDrawList& list, const Rect& area) : list_(&list), whole_(list.CmdBuffer) {
        for (ImDrawCmd& command : list.CmdBuffer) {
            command.ClipRect = common(command.ClipRect, area);
            reaches_ = reaches_ || (command.ClipRect.z > command.ClipRect.x &&
                                    command.ClipRect.w > command.ClipRect.y);
        }
    }
    ~Clipped() { list_->CmdBuffer.swap(whole_); }
    Clipped(const Clipped&) = delete;
    Clipped& operator=(const Clipped&) = delete;

    bool reaches() const { return reaches_; }

private:
    ImDrawList* list_;
    ImVector<ImDrawCmd> whole_;
    bool reaches_ = false;
};

void clear(const ImDrawData& data, const Rect& area, const Color& color) {
    const ImVec2 scale = data.FramebufferScale;
    const auto pixels = [](float length) { return static_cast<GLint>(length); };
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixels((area.x - data.DisplayPos.x) * scale.x),
              pixels((data.DisplayPos.y + data.DisplaySize.y - area.high().y) * scale.y),
              pixels(area.width * scale.x), pixels(area.height * scale.y));
    glClearColor(color.r, color.g, color.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

void paint_area(const ImDrawData& data, const Rect& area, const Color& background) {
    clear(data, area, background);
    std::deque<Clipped> clipped;
    std::vector<ImDrawList*> lists;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const Clipped& list = clipped.emplace_back(*data.CmdLists[i], area);
        if (list.reaches()) lists.push_back(data.CmdLists[i]);
    }
    ImDrawData part = data;
    part.CmdLists = lists.data();
    part.CmdListsCount = static_cast<int>(lists.size());
    ImGui_ImplOpenGL3_RenderDrawData(&part);
}

}  // namespace cambrian
