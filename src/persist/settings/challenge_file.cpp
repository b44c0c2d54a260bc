#include "persist/settings/challenge_file.h"

#include "persist/settings/challenge_table.h"
#include "persist/settings/settings_file.h"
#include "persist/text/error_list.h"
#include "persist/text/quoted_text.h"
#include "simulator/simulator_version.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cambrian {
namespace {

constexpr const char* kChallengeTable = "challenge";
constexpr const char* kNameKey = "name";
constexpr const char* kHeldOutKey = "held-out-seed";
constexpr const char* kSimulatorKey = "simulator";
constexpr int kEndless = 1'000'000;  // generations

constexpr const char* kChallengeHead =
    "# A challenge: `cambrian evolve THIS-FILE` searches with its seed and number of trials, and\n"
    "# `cambrian challenge enter THIS-FILE CREATURE... -o board.html` ranks creatures in its "
    "world.\n";

// Reads the keys of the table [challenge] and says what is wrong with each.
class ChallengeTableReader {
public:
    ChallengeTableReader(const toml::table& table, ErrorList& errors)
        : table_(table), errors_(errors) {}

    ChallengeTable read() {
        ChallengeTable read;
        read.name = text(kNameKey);
        if (read.name.empty() || read.name.size() > kLongestChallengeName)
            error(kNameKey, fmt::format("expected a text of 1 to {} bytes", kLongestChallengeName));
        const auto seed = table_[kHeldOutKey].value_exact<std::int64_t>();
        if (seed && *seed >= 0 && *seed <= kMostChallengeSeed)
            read.held_out_seed = static_cast<std::uint64_t>(*seed);
        else
            error(kHeldOutKey,
                  fmt::format("expected a whole number of 0 to {}", kMostChallengeSeed));
        read.simulator = text(kSimulatorKey);
        for (const auto& [key, node] : table_) {
            constexpr std::array kKnown = {kNameKey, kHeldOutKey, kSimulatorKey};
            const std::string_view name = key.str();
            if (std::find(kKnown.begin(), kKnown.end(), name) == kKnown.end())
                error(shown(name), "unknown key");
        }
        return read;
    }
    void error(std::string_view key, std::string_view message) {
        const toml::node* node = table_.get(key);
        const auto line = (node == nullptr ? table_.source() : node->source()).begin.line;
        errors_.error("", fmt::format("line {}, [{}] {}", line, kChallengeTable, key), message);
    }

private:
    std::string text(const char* key) const {
        return table_[key].value_exact<std::string>().value_or(std::string());
    }

    const toml::table& table_;
    ErrorList& errors_;
};

}  // namespace

Challenge make_challenge(ExperimentSettings settings, ChallengeTable table, int trials) {
    settings.max_evaluations = trials;
    settings.generations = kEndless;
    settings.target_fitness = 0.0;
    return {std::move(table), std::move(settings)};
}

Result<std::optional<ChallengeTable>> take_challenge(toml::table& document, std::string_view source,
                                                     int dimensions) {
    const toml::node* node = document.get(kChallengeTable);
    if (node == nullptr) return std::optional<ChallengeTable>();
    ErrorList errors;
    const toml::table* table = node->as_table();
    if (table == nullptr) {
        errors.error("", fmt::format("line {}, {}", node->source().begin.line, kChallengeTable),
                     "expected a table");
        return errors.as_error(source);
    }
    ChallengeTableReader reader(*table, errors);
    ChallengeTable taken = reader.read();
    const std::string_view present = simulator_version(dimensions);
    if (taken.simulator != present)
        reader.error(kSimulatorKey,
                     fmt::format("the challenge is for simulator {}, this is {}; `cambrian "
                                 "challenge new` makes one for it",
                                 shown(taken.simulator), present));
    if (!errors.empty()) return errors.as_error(source);
    document.erase(kChallengeTable);
    return std::optional(std::move(taken));
}

Result<Challenge> parse_challenge(std::string_view text, std::string_view source,
                                  const EvolutionKinds& kinds) {
    Result<ExperimentSettings> settings = parse_settings(text, source, kinds);
    if (!settings) return settings.error();
    toml::parse_result document = parse_toml(text);
    auto table = take_challenge(document.table(), source, kinds.creature.scene.dimensions);
    if (!table) return table.error();
    if (!*table)
        return Error{
            fmt::format("{}: is no challenge but settings; `cambrian challenge new` makes "
                        "a challenge of them",
                        source)};
    return Challenge{**std::move(table), *std::move(settings)};
}

Result<Challenge> load_challenge(const std::filesystem::path& path, const EvolutionKinds& kinds) {
    const Result<SettingsText> text = read_settings_text(path);
    return text ? parse_challenge(text->text, text->source, kinds)
                : Result<Challenge>(text.error());
}

std::string write_challenge(const Challenge& challenge, const EvolutionKinds& kinds) {
    const ChallengeTable& table = challenge.table;
    return fmt::format("{}\n[{}]\n{} = {}\n{} = {}\n{} = {}\n\n{}", kChallengeHead, kChallengeTable,
                       kNameKey, quoted_text(table.name), kHeldOutKey, table.held_out_seed,
                       kSimulatorKey, quoted_text(table.simulator),
                       write_settings(challenge.settings, kinds));
}

}  // namespace cambrian
