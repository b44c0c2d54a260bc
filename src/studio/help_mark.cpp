#include "studio/help_mark.h"

#include "studio/widgets.h"

namespace cambrian {

void help_mark(const char* page, Requests& out) {
    if (push_button("? " + std::string(page), {.look = ButtonLook::kGhost,
                                               .icon = Icon::kHelp,
                                               .label_shown = false,
                                               .width = px(24),
                                               .height = px(22),
                                               .tooltip = "What is this? Opens its help page."}))
        out.ask(ShowHelp{page});
}

void place_title(const std::string& title, const char* page, Requests& out) {
    panel_title(title);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - px(24));
    help_mark(page, out);
}

}  // namespace cambrian
