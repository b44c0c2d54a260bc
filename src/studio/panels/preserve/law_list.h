#pragma once

#include "evolution/fields/setting_field.h"
#include "studio/frame/panel.h"

#include <optional>
#include <vector>

namespace cambrian {

// The laws of a preserve that may change while it goes on. A law takes effect when its control is
// released.
class LawList final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    std::vector<SettingField> laws_;            // listed when first drawn
    std::optional<ExperimentSettings> edited_;  // while a control is held
    unsigned seen_ = 0;                         // TypeLaws requests
};

}  // namespace cambrian
