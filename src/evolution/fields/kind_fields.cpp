// Settings that enable or disable each kind of joint, neuron function, sensor, organ and reference.
#include "evolution/fields/setting_table.h"
#include "genome/founders/enabled_kinds.h"

#include <fmt/core.h>

namespace cambrian::setting_table {
namespace {

using Flags = std::map<std::string, bool>;

template <class Entries>
void add_switches(std::vector<SettingField>& fields, std::string table, const Entries& entries,
                  const std::string& help, Flags FounderSettings::*flags) {
    TableBuilder builder(fields, std::move(table));
    for (const auto& entry : entries) {
        const std::string id(entry.id);
        SettingField& field = builder.flag(
            [ flags, id, usual = is_usual(entry) ](Settings & s) -> auto& {
                return (s.founders.*flags).try_emplace(id, usual).first->second;
            },
            id, std::string(entry.label), help);
        field.later = !is_usual(entry) && flags != &FounderSettings::joints;
        if constexpr (requires { entry.group; }) field.group = entry.group;
    }
}

// Checks that at least one kind is enabled.
template <class Entry>
Status check_any(const std::vector<Entry>& entries, const std::vector<std::uint8_t>& enabled,
                 const Flags& flags, const char* table) {
    for (const std::uint8_t entry : enabled) {
        const auto flag = flags.find(entries[entry].id);
        if (flag == flags.end() || flag->second) return {};
    }
    return Error{fmt::format("[{}]: all are false; at least one must be true", table)};
}

std::string joined_ids(const std::vector<SourceKind>& kinds) {
    std::string ids;
    for (const SourceKind kind : kinds)
        ids += (ids.empty() ? "" : ", ") + std::string(source_rule(kind).id);
    return ids;
}

// Returns the kinds of source that effectors may use: all but constants.
std::vector<SourceKind> changing_references(const FounderSettings& founders,
                                            const KindCatalog& catalog) {
    auto kinds = enabled_references(SourceScope::kPart, founders, catalog);
    std::erase(kinds, SourceKind::kConstant);
    return kinds;
}

Status check_references(const FounderSettings& founders, const KindCatalog& catalog) {
    FounderSettings free = founders;
    free.references.clear();
    if (changing_references(founders, catalog).empty()) {
        return Error{
            "[body.references]: joints would have nothing to follow; at least one must be "
            "true of " +
            joined_ids(changing_references(free, catalog))};
    }
    if (enabled_references(SourceScope::kBrain, founders, catalog).empty()) {
        return Error{
            "[body.references]: central neurons would have nothing to read; at least one "
            "must be true of " +
            joined_ids(enabled_references(SourceScope::kBrain, free, catalog))};
    }
    return {};
}

}  // namespace

void add_body_kinds(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    const KindCatalog& catalog = kinds.creature.catalog;
    add_switches(fields, "body.joints", catalog.joints,
                 "Random creatures and mutations may use this joint.", &FounderSettings::joints);
    add_switches(fields, "body.functions", catalog.functions,
                 "Random creatures and mutations may use this neuron function.",
                 &FounderSettings::functions);
    add_switches(fields, "body.sensors", catalog.channels,
                 "Random creatures and mutations may connect to this sensor.",
                 &FounderSettings::channels);
    add_switches(fields, "body.organs", catalog.organs,
                 "Random creatures and mutations may use this organ.", &FounderSettings::organs);
    add_switches(fields, "body.references", source_rules(),
                 "Random creatures and mutations may connect to this source.",
                 &FounderSettings::references);
}

Status check_body_kinds(const Settings& settings, const EvolutionKinds& kinds) {
    const KindCatalog& catalog = kinds.creature.catalog;
    const FounderSettings& founders = settings.founders;
    const auto joints = enabled_joints(founders, catalog);
    if (Status any = check_any(catalog.joints, joints, founders.joints, "body.joints"); !any)
        return any;
    bool moves = false;
    for (const std::uint8_t joint : joints)
        moves = moves || catalog.joints[joint].degrees_of_freedom > 0;
    // A part has one organ of these kinds: they deform it.
    for (const std::uint8_t organ : enabled_organs(founders, catalog))
        moves = moves || catalog.organs[organ].single;
    if (!moves)
        return Error{
            "[body.joints]: none that moves is true; at least one must be, or an organ that "
            "deforms"};
    if (Status any = check_any(catalog.functions, enabled_functions(founders, catalog),
                               founders.functions, "body.functions");
        !any)
        return any;
    return check_references(founders, catalog);
}

}  // namespace cambrian::setting_table
