#include "persist/creature/creature_format.h"

#include <array>

namespace cambrian::creature_format {
namespace {

constexpr std::array kScoreTables = {"goal", "environment", "simulation", "trial"};
// Settings of the table [body] on which expression depends; the others concern founders.
constexpr std::array kGrowthKeys = {"max-parts", "max-depth", "max-neurons", "strict-overlap"};

// The channels by their numbers in files of version 1. Newer channels have no number.
constexpr std::array kChannelsOfVersion1 = {"joint", "contact-distal", "contact-left",
                                            "contact-proximal", "contact-right"};

bool decides_a_score(const SettingField& field) {
    if (field.table == "body")
        return std::find(kGrowthKeys.begin(), kGrowthKeys.end(), field.key) != kGrowthKeys.end();
    return std::find(kScoreTables.begin(), kScoreTables.end(), field.table) != kScoreTables.end();
}

}  // namespace

KindNames names_of(const KindCatalog& catalog) {
    KindNames names;
    for (const FunctionEntry& function : catalog.functions) {
        names.functions.push_back(function.id);
        names.arities.push_back(function.arity);
    }
    names.dimensions = catalog.dimensions;
    for (const JointChoice& joint : catalog.joints)
        names.joints.push_back(joint.id);
    for (const EffectorEntry& effector : catalog.effectors)
        names.effectors.push_back(effector.id);
    for (const ChannelEntry& channel : catalog.channels)
        names.channels.names.push_back(channel.id);
    for (const OrganEntry& organ : catalog.organs) {
        names.organs.push_back(organ.id);
        names.parameters.push_back(organ.parameters);
        names.single.push_back(organ.single);
    }
    names.reproductions = catalog.reproductions;
    names.channels.numbered.assign(kChannelsOfVersion1.begin(), kChannelsOfVersion1.end());
    return names;
}

std::vector<ScoreTable> score_tables(const EvolutionKinds& kinds) {
    std::vector<ScoreTable> tables;
    for (SettingField& field : setting_fields(kinds)) {
        if (!decides_a_score(field)) continue;
        if (tables.empty() || tables.back().name != field.table)
            tables.push_back({field.table, {}});
        tables.back().fields.push_back(std::move(field));
    }
    return tables;
}

}  // namespace cambrian::creature_format
