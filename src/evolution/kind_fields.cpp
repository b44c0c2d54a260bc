// Which kinds of parts a body and a brain may be made of: one switch for each kind there is.
#include "evolution/setting_table.h"
#include "genome/enabled_kinds.h"

namespace cambrian::setting_table {
namespace {

using Flags = std::map<std::string, bool>;

template <class Entry>
void add_switches(std::vector<SettingField>& fields, std::string table,
                  const std::vector<Entry>& entries, const std::string& help,
                  Flags FounderSettings::*flags, bool (*usual)(std::string_view id)) {
    TableBuilder builder(fields, std::move(table));
    for (const Entry& entry : entries) {
        builder.flag(
            entry.id, entry.label, help,
            [ flags, id = entry.id, standard = usual(entry.id) ](Settings & s) -> auto& {
                return (s.founders.*flags).try_emplace(id, standard).first->second;
            });
    }
}

bool always(std::string_view /*id*/) {
    return true;
}

// Without any switch on there is nothing to draw from.
template <class Entry>
Status check_any(const std::vector<Entry>& entries, const std::vector<std::uint8_t>& enabled,
                 const Flags& flags, const char* table) {
    for (const std::uint8_t entry : enabled) {
        const auto flag = flags.find(entries[entry].id);
        if (flag == flags.end() || flag->second) return {};
    }
    return Error{std::string("[") + table + "]: all are false; at least one must be true"};
}

}  // namespace

void add_body_kinds(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    const KindCatalog& catalog = kinds.creature.catalog;
    add_switches(fields, "body.joints", catalog.joints,
                 "Whether random creatures and mutations may use this joint.",
                 &FounderSettings::joints, usual_joint);
    add_switches(fields, "body.functions", catalog.functions,
                 "Whether random creatures and mutations may use this neuron.",
                 &FounderSettings::functions, always);
    add_switches(fields, "body.sensors", catalog.channels,
                 "Whether random creatures and mutations may connect to this sensor.",
                 &FounderSettings::channels, always);
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
    return check_any(catalog.functions, enabled_functions(founders, catalog), founders.functions,
                     "body.functions");
}

}  // namespace cambrian::setting_table
