#pragma once

#include "studio/panel.h"

#include <map>
#include <string>

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
    void draw_group(const Group& group, const FrameContext& frame, Requests& out);
    bool draw_header(const Group& group);
    std::vector<Group> list_groups(const FrameContext& frame, ExperimentSettings& draft,
                                   ExperimentSettings& defaults) const;

    std::map<std::string, bool> open_;  // by table; absent: as at first
};

}  // namespace cambrian
