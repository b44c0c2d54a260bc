// Fuzzes settings files, of experiments in the plane and in space and of preserves: the reader
// gives settings that pass their check, or a message. Loaded settings are written and read again
// without change.

#include "evolution/fields/setting_field.h"
#include "fuzz/fuzz_target.h"
#include "persist/settings/settings_file.h"
#include "support/kinds.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

void read_as(SettingsUse use, std::string_view input) {
    const EvolutionKinds& all = dimensions_of_settings(input) == 3 ? spatial_kinds() : kinds();
    const auto settings = parse_settings(input, "input", all, use);
    if (!settings) {
        promise(settings.error().message.starts_with("input: "), "a refusal names the file");
        return;
    }
    const Status check = use == SettingsUse::kPreserve ? check_preserve(*settings, all)
                                                       : check_settings(*settings, all);
    promise(check.has_value(), "what is loaded passes its check");
    const std::string text = write_settings(*settings, all, use);
    const auto again = parse_settings(text, "again", all, use);
    promise(again.has_value(), "what is written can be read");
    promise(write_settings(*again, all, use) == text, "writing again gives the same bytes");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const SettingsUse use : {SettingsUse::kExperiment, SettingsUse::kPreserve})
        read_as(use, text_of(data, size));
    return 0;
}
