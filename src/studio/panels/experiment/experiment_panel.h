#pragma once

#include "studio/experiment/setting_filter.h"
#include "studio/frame/panel.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace cambrian {

// All settings, generated from the table of fields, by group.
class ExperimentPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    struct Group {
        std::string table;
        std::string title;
        int changed = 0;  // fields that differ from their default
    };
    void draw_run_warning(const FrameContext& frame, Requests& out);
    void draw_filter(const FrameContext& frame);
    void draw_found(const std::vector<Group>& groups, const SettingFilter& filter,
                    const FrameContext& frame, Requests& out);
    void draw_group(const Group& group, const FrameContext& frame, Requests& out);
    void draw_row(const SettingField& field, const FrameContext& frame, Requests& out);
    bool draw_header(const Group& group);
    std::vector<Group> list_groups(const FrameContext& frame, ExperimentSettings& draft,
                                   ExperimentSettings& defaults) const;

    std::array<char, 64> filter_{};
    unsigned find_seen_ = 0;            // the last time a setting was to be found
    bool first_wanted_ = false;         // the first value found gets the keyboard
    std::map<std::string, bool> open_;  // by table; absent: as at first
};

}  // namespace cambrian
