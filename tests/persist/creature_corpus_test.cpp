// Reads the creature files of tests/persist/creatures. The first word of each name says what the
// result must be.

#include "core/files/file_io.h"
#include "persist/creature/creature_file.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>
#include <map>

using namespace cambrian;
using namespace cambrian::test;

namespace {

const std::filesystem::path kFolder = CAMBRIAN_SOURCE_DIR "/tests/persist/creatures";

// Returns the files by first word: "E07", "W01" or "sound".
std::map<std::string, std::vector<std::filesystem::path>> files_by_verdict() {
    std::map<std::string, std::vector<std::filesystem::path>> files;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
        const std::string name = entry.path().stem().stem().string();
        files[name.substr(0, name.find('_'))].push_back(entry.path());
    }
    return files;
}

}  // namespace

TEST_CASE("every code of the format has files that are kept", "[persist][creature_corpus]") {
    const auto files = files_by_verdict();
    for (const char* code : {"E01", "E02", "E03", "E04", "E05", "E06", "E07", "E08", "E09", "E10",
                             "E11", "E12", "E13", "W01", "W02", "W03", "W04", "W05", "sound"}) {
        INFO(code);
        CHECK(files.contains(code));
    }
}

TEST_CASE("each kept creature file is refused with the code in its name, or loads",
          "[persist][creature_corpus]") {
    for (const auto& [verdict, paths] : files_by_verdict()) {
        for (const std::filesystem::path& path : paths) {
            INFO(path.filename().string());
            const auto loaded = load_creature(path, kinds());
            if (verdict.front() == 'E') {
                REQUIRE_FALSE(loaded);
                CHECK_THAT(loaded.error().message,
                           Catch::StartsWith(path.string() + ": " + verdict + " "));
                continue;
            }
            INFO((loaded ? "loads" : loaded.error().message));
            REQUIRE(loaded);
            auto warnings = loaded->warnings;
            for (const auto& each : foreign_kinds(loaded->genome(), FounderSettings{}, kinds()))
                warnings.push_back(each);
            REQUIRE(warnings.size() == (verdict == "sound" ? 0 : 1));
            if (verdict != "sound") CHECK_THAT(warnings.front(), Catch::StartsWith(verdict + " "));
        }
    }
}

TEST_CASE("W04: what an experiment has not enabled is told once, where it is used first",
          "[persist][creature_corpus]") {
    const auto linear = load_creature(kFolder / "W04_linear_joint.creature.json", kinds());
    REQUIRE(linear);
    FounderSettings settings;
    settings.functions["abs"] = false;
    for (const ChannelEntry& channel : kinds().creature.catalog.channels)
        settings.channels[channel.id] = false;
    const auto messages = foreign_kinds(linear->genome(), settings, kinds());
    REQUIRE(messages.size() == 4);
    CHECK(messages[0] == "W04 /nodes/1/joint: joint \"linear\" is not enabled in this experiment");
    CHECK_THAT(messages[1], Catch::StartsWith("W04 /nodes/1/neurons/0/in/1/from/ch: sensor "));
    CHECK(messages[2] == "W04 /brain/0/fn: function \"abs\" is not enabled in this experiment");
    CHECK_THAT(messages[3], Catch::StartsWith("W04 /brain/0/in/0/from/ch: sensor "));
    settings.joints["linear"] = true;
    CHECK(foreign_kinds(linear->genome(), settings, kinds()).size() == 3);
}
