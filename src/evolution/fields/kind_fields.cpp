// Settings that enable or disable each kind of joint, neuron function, sensor and reference.
#include "evolution/fields/setting_table.h"
#include "genome/founders/enabled_kinds.h"

namespace cambrian::setting_table {
namespace {

using Flags = std::map<std::string, bool>;

template <class Entries>
void add_switches(std::vector<SettingField>& fields, std::string table, const Entries& entries,
                  const std::string& help, Flags FounderSettings::*flags) {
    TableBuilder builder(fields, std::move(table));
    for (const auto& entry : entries) {
        const std::string id(entry.id);
        builder
            .flag(
                id, std::string(entry.label), help,
                [ flags, id, usual = is_usual(entry) ](Settings & s) -> auto& {
                    return (s.founders.*flags).try_emplace(id, usual).first->second;
                })
            .later = !is_usual(entry) && flags == &FounderSettings::channels;
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
    return Error{std::string("[") + table + "]: all are false; at least one must be true"};
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
                 "Whether random creatures and mutations may use this joint.",
                 &FounderSettings::joints);
    add_switches(fields, "body.functions", catalog.functions,
                 "Whether random creatures and mutations may use this neuron.",
                 &FounderSettings::functions);
    add_switches(fields, "body.sensors", catalog.channels,
                 "Whether random creatures and mutations may connect to this sensor.",
                 &FounderSettings::channels);
    add_switches(fields, "body.references", source_rules(),
                 "Whether random creatures and mutations may connect to this.",
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
    if (!moves) return Error{"[body.joints]: none that moves is true; at least one must be"};
    if (Status any = check_any(catalog.functions, enabled_functions(founders, catalog),
                               founders.functions, "body.functions");
        !any)
        return any;
    return check_references(founders, catalog);
}

}  // namespace cambrian::setting_table
