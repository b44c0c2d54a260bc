#pragma once

#include "studio/comparison/comparison_contract.h"
#include "studio/frame/panel.h"

#include <array>

namespace cambrian {

// The card on which settings are compared: what is varied, the runs under way, and their results.
class ComparisonPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    static constexpr std::size_t kLongest = 256;  // bytes in a field
    using Text = std::array<char, kLongest>;

    // Each changes the draft and returns whether it did.
    bool draw_varied(const FrameContext& frame, ComparisonDraft& draft);
    bool draw_values(ComparisonDraft& draft);
    bool draw_choice_of_setting(const FrameContext& frame, ComparisonDraft& draft, float width);
    bool list_settings(const FrameContext& frame, ComparisonDraft& draft);

    Text values_ = {};
    Text find_ = {};     // words by which settings are found
    std::string shown_;  // values that the field showed before they were edited
};

}  // namespace cambrian
