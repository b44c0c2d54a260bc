#include "core/text/nearest_name.h"
#include "persist/settings/challenge_table.h"
#include "persist/settings/settings_file.h"
#include "persist/settings/toml.h"
#include "persist/text/error_list.h"
#include "persist/text/setting_value.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

constexpr const char* kPreserveTable = "preserve";

std::string line_of(const toml::source_region& region) {
    return fmt::format("line {}", region.begin.line);
}

SettingValue setting_value(const toml::node& node) {
    if (const auto* flag = node.as_boolean()) return flag->get();
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* real = node.as_floating_point()) return real->get();
    if (const auto* text = node.as_string()) return text->get();
    return {};
}

// Returns the path of a key or table in a table. The top level has an empty path.
std::string joined(const std::string& table, const std::string& key) {
    if (table.empty()) return key;
    std::string path = table;
    path += '.';
    path += key;
    return path;
}

// Visits the tables of a file and stores their values in the settings.
class SettingsReader {
public:
    SettingsReader(std::vector<SettingField> fields, ExperimentSettings defaults, ErrorList& errors)
        : fields_(std::move(fields)), errors_(errors), settings_(std::move(defaults)) {}

    void read(const toml::table& table, const std::string& path = "") {
        for (const auto& [key, node] : table) {
            if (errors_.full()) return;
            const std::string name(key.str());
            const std::string inner = joined(path, name);
            if (node.is_table() && names_table(inner)) {
                read(*node.as_table(), inner);
            } else {
                read_setting(path, name, node, line_of(key.source()));
            }
        }
    }
    const ExperimentSettings& settings() const { return settings_; }

private:
    // Returns whether [path] is a table of settings or contains one.
    bool names_table(const std::string& path) const {
        return std::any_of(fields_.begin(), fields_.end(), [&](const SettingField& field) {
            return field.table == path || field.table.rfind(path + ".", 0) == 0;
        });
    }

    void read_setting(const std::string& table, const std::string& key, const toml::node& node,
                      const std::string& line) {
        const auto field = std::find_if(
            fields_.begin(), fields_.end(),
            [&](const SettingField& each) { return each.table == table && each.key == key; });
        if (names_table(joined(table, key))) {
            errors_.error("", fmt::format("{}, {}", line, place(table, key, false)),
                          "expected a table");
            return;
        }
        if (field == fields_.end()) {
            const bool is_table = node.is_table();
            errors_.error("", fmt::format("{}, {}", line, place(table, key, is_table)),
                          is_table ? unknown_table(table, key) : unknown_key(table, key));
            return;
        }
        const SettingCheck check = assign(*field, setting_value(node), settings_);
        if (check.fault != SettingFault::kNone)
            errors_.error("", fmt::format("{}, {}", line, place(table, key, false)), check.message);
    }

    static std::string place(const std::string& table, const std::string& key, bool is_table) {
        if (is_table) return fmt::format("[{}]", joined(table, shown(key)));
        return table.empty() ? shown(key) : fmt::format("[{}] {}", table, shown(key));
    }

    std::string unknown_table(const std::string& table, const std::string& key) const {
        std::vector<std::string> tables;
        for (const SettingField& field : fields_)
            tables.push_back(field.table);
        const std::string near = nearest_name(joined(table, key), tables);
        return near.empty() ? "unknown table"
                            : fmt::format("unknown table; did you mean [{}]?", near);
    }

    // Suggests the nearest key of the same table, else the nearest of any table, else all of the
    // table.
    std::string unknown_key(const std::string& table, const std::string& key) const {
        std::vector<std::string> here;
        std::vector<std::string> anywhere;
        for (const SettingField& field : fields_) {
            anywhere.push_back(field.key);
            if (field.table == table) here.push_back(field.key);
        }
        std::string near = nearest_name(key, here);
        if (!near.empty()) return fmt::format("unknown key; did you mean \"{}\"?", near);
        near = nearest_name(key, anywhere);
        if (near.empty()) return "unknown key" + known_in_words(here);
        const auto field = std::find_if(fields_.begin(), fields_.end(),
                                        [&](const SettingField& each) { return each.key == near; });
        return fmt::format("unknown key; did you mean [{}] {}?", field->table, near);
    }

    static std::string known_in_words(const std::vector<std::string>& keys) {
        std::string words;
        for (const std::string& key : keys)
            words += (words.empty() ? "; known are " : ", ") + key;
        return words;
    }

    std::vector<SettingField> fields_;
    ErrorList& errors_;
    ExperimentSettings settings_;
};

// Settings of the plane may name their dimensions, which are no setting there.
Status take_dimensions(toml::table& document, const EvolutionKinds& kinds) {
    if (kinds.creature.scene.dimensions == 3) return {};
    toml::table* environment = document["environment"].as_table();
    if (environment == nullptr || !environment->contains("dimensions")) return {};
    if (environment->at_path("dimensions").value_exact<std::int64_t>() != 2)
        return Error{
            "[environment] dimensions: this is possible only in two dimensions yet, so expected 2"};
    environment->erase("dimensions");
    return {};
}

}  // namespace

int dimensions_of_settings(std::string_view text) {
    const toml::parse_result document = parse_toml(text);
    if (!document) return 2;
    const auto named = document.table()["environment"]["dimensions"].value_exact<std::int64_t>();
    return named == 3 ? 3 : 2;
}

Result<ExperimentSettings> parse_settings(std::string_view text, std::string_view source,
                                          const EvolutionKinds& kinds, SettingsUse use) {
    return merge_settings({{std::string(text), std::string(source)}}, kinds, use);
}

SettingsUse use_of_settings(std::string_view text) {
    const toml::parse_result document = parse_toml(text);
    const bool preserve = document && document.table().contains(kPreserveTable);
    return preserve ? SettingsUse::kPreserve : SettingsUse::kExperiment;
}

Result<ExperimentSettings> merge_settings(const std::vector<SettingsText>& texts,
                                          const EvolutionKinds& kinds, SettingsUse use) {
    const bool preserve = use == SettingsUse::kPreserve;
    std::vector<toml::table> documents;
    std::string goal;
    bool has_ground = false;
    for (const auto& [text, source] : texts) {
        ErrorList errors;
        toml::parse_result document = parse_toml(text);
        if (!document) {
            errors.error("", line_of(document.error().source()),
                         shown(document.error().description(), kLongestReason));
            return errors.as_error(source);
        }
        if (const toml::node* table = document.table().get(kPreserveTable);
            table != nullptr && !preserve) {
            errors.error("", fmt::format("{}, [{}]", line_of(table->source()), kPreserveTable),
                         "these are the settings of a preserve; `cambrian preserve` takes them");
            return errors.as_error(source);
        }
        if (Status here = take_dimensions(document.table(), kinds); !here)
            return Error{fmt::format("{}: {}", source, here.error().message)};
        const auto challenge =
            take_challenge(document.table(), source, kinds.creature.scene.dimensions);
        if (!challenge) return challenge.error();
        goal = document["goal"]["behavior"].value_or(goal);
        has_ground = document["environment"]["ground"].value_exact<bool>().value_or(has_ground);
        documents.push_back(std::move(document).table());
    }
    ErrorList errors;
    if (kinds.goals.find(goal) == nullptr) goal.clear();
    SettingsReader reader(
        preserve ? preserve_fields(kinds) : setting_fields(kinds),
        preserve ? preserve_defaults(kinds, has_ground) : default_settings(goal, kinds), errors);
    std::string sources;
    for (std::size_t i = 0; i < documents.size(); ++i) {
        reader.read(documents[i]);
        if (!errors.empty()) return errors.as_error(texts[i].source);
        sources += (i == 0 ? "" : " with ") + texts[i].source;
    }
    const Status contradiction = preserve ? check_preserve(reader.settings(), kinds)
                                          : check_settings(reader.settings(), kinds);
    if (!contradiction) return Error{fmt::format("{}: {}", sources, contradiction.error().message)};
    return reader.settings();
}

}  // namespace cambrian
