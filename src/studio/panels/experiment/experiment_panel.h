#pragma once

#include "studio/experiment/setting_filter.h"
#include "studio/frame/panel.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace cambrian {

// Shows the settings that matter most in plain words or all settings by group, generated from the
// table of fields.
class ExperimentPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    struct Group {
        std::string table;
        std::string title;
        int changed = 0;  // number of fields that differ from their default
    };
    void draw_run_warning(const FrameContext& frame, Requests& out);
    void draw_extent(const FrameContext& frame, Requests& out);
    void draw_filter(const FrameContext& frame);
    static void draw_dimensions(const FrameContext& frame, Requests& out);
    static void draw_world(const FrameContext& frame, Requests& out);
    void draw_plain(const FrameContext& frame, Requests& out);
    void draw_other_changes(const FrameContext& frame, Requests& out);
    void seek(const FrameContext& frame);
    void light_up(const std::string& path);
    void draw_found(const std::vector<Group>& groups, const SettingFilter& filter,
                    const FrameContext& frame, Requests& out);
    void draw_group(const Group& group, const FrameContext& frame, Requests& out);
    void draw_switch_groups(const std::string& table, const FrameContext& frame, Requests& out);
    void draw_row(const SettingField& field, const FrameContext& frame, Requests& out);
    bool draw_header(const Group& group);
    std::vector<Group> list_groups(const FrameContext& frame, ExperimentSettings& draft,
                                   ExperimentSettings& defaults) const;

    std::array<char, 64> filter_{};
    unsigned find_seen_ = 0;     // the count of FindSetting requests in the last frame
    bool first_wanted_ = false;  // moves the keyboard focus to the first value found
    unsigned show_seen_ = 0;     // the count of ShowSetting requests in the last frame
    std::string sought_;         // path of the setting to scroll to
    std::string lit_;            // path of the one that is lit up
    double lit_until_ = 0.0;     // s
    // Whether the user opened a table; an absent one is as at the start.
    std::map<std::string, bool> open_;
};

}  // namespace cambrian
