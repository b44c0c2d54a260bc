#include "studio/panels/preserve/law_list.h"

#include "preserve/laws.h"
#include "studio/panels/experiment/setting_row.h"
#include "studio/widgets/widgets.h"

#include <utility>

namespace cambrian {

void LawList::draw(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    if (!preserve.founding) return;
    if (laws_.empty()) laws_ = changeable_laws(frame.kinds);
    if (std::exchange(seen_, preserve.laws_asked) != preserve.laws_asked)
        ImGui::SetKeyboardFocusHere();
    if (!ImGui::IsAnyItemActive()) edited_.reset();
    ExperimentSettings present = edited_.value_or(*preserve.picture.laws);
    ExperimentSettings founding = *preserve.founding;
    for (const SettingField& law : laws_) {
        const RowEvent event = setting_row(law, present, founding);
        if (event == RowEvent::kEdited) edited_ = present;
        if (event != RowEvent::kFinished) continue;
        out.ask(SetLaw{law, law_value(law, present)});
        edited_.reset();
    }
    muted_text("A dot marks what is not as it was at the start; a right-click resets it.");
}

}  // namespace cambrian
