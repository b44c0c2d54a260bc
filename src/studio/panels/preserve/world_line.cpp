#include "studio/panels/preserve/world_line.h"

#include "studio/preserve/world_words.h"
#include "studio/widgets/widgets.h"

#include <cmath>

namespace cambrian {

void WorldLine::draw(const FrameContext& frame, Requests&) {
    const PreservePicture& picture = frame.preserve->picture;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::Dummy(room);
    note_place("world line");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = at.y + 0.5F * room.y;
    list.AddCircleFilled({at.x + px(4), middle}, px(4),
                         paint(picture.failure.empty() ? colors().accent : colors().danger));
    const WithFont font(ui().fonts.small);
    list.AddText({at.x + px(18), std::round(middle - 0.5F * ImGui::GetFontSize())},
                 paint(colors().muted), fit_text(world_words(picture), room.x - px(18)).c_str());
}

}  // namespace cambrian
