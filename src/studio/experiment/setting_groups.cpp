#include "studio/experiment/setting_groups.h"

#include "core/text/pretty_text.h"

#include <algorithm>

namespace cambrian {
namespace {

struct GroupName {
    std::string_view table;
    std::string_view title;
    bool open;
};

// The groups in the order shown. Tables that are not listed follow under their own name.
constexpr std::array kGroups = {
    GroupName{"goal", "Goal", true},
    GroupName{"environment", "Environment", true},
    GroupName{"population", "Population", true},
    GroupName{"selection", "Selection", true},
    GroupName{"breeding", "Breeding", false},
    GroupName{"mutation", "Mutation", true},
    GroupName{"mutation.weights", "Mutation weights", false},
    GroupName{"body", "Body and brain", false},
    GroupName{"body.joints", "Joints allowed", false},
    GroupName{"body.functions", "Neurons allowed", false},
    GroupName{"body.sensors", "Senses", false},
    GroupName{"body.organs", "Organs allowed", false},
    GroupName{"body.references", "Links allowed", false},
    GroupName{"simulation", "Physics", false},
    GroupName{"trial", "Trial", false},
    GroupName{"run", "Run", false},
};

}  // namespace

std::string shown_table(const SettingField& field) {
    constexpr std::array<std::string_view, 2> senses = {"deafness", "anosmia"};
    const bool sense = field.table == "environment" &&
                       std::find(senses.begin(), senses.end(), field.key) != senses.end();
    return sense ? "body.sensors" : field.table;
}

std::size_t group_rank(std::string_view table) {
    const auto found = std::find_if(kGroups.begin(), kGroups.end(),
                                    [table](const GroupName& each) { return each.table == table; });
    return static_cast<std::size_t>(found - kGroups.begin());
}

std::string group_title(const std::string& table) {
    const std::size_t rank = group_rank(table);
    return rank == kGroups.size() ? capitalized(table) : std::string(kGroups[rank].title);
}

bool is_open_at_first(std::string_view table) {
    const std::size_t rank = group_rank(table);
    return rank < kGroups.size() && kGroups[rank].open;
}

bool is_plain(std::string_view path) {
    return std::find(kPlainSettings.begin(), kPlainSettings.end(), path) != kPlainSettings.end();
}

}  // namespace cambrian
