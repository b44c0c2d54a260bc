// Fuzzes settings files: the reader gives settings that pass their check, or a message. Loaded
// settings are written and read again without change.

#include "evolution/fields/setting_field.h"
#include "fuzz/fuzz_target.h"
#include "persist/settings/settings_file.h"
#include "support/kinds.h"

using namespace cambrian;
using namespace cambrian::test;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto settings = parse_settings(text_of(data, size), "input", kinds());
    if (!settings) {
        promise(settings.error().message.starts_with("input: "), "a refusal names the file");
        return 0;
    }
    promise(check_settings(*settings, kinds()).has_value(), "what is loaded passes its check");
    const std::string text = write_settings(*settings, kinds());
    const auto again = parse_settings(text, "again", kinds());
    promise(again.has_value(), "what is written can be read");
    promise(write_settings(*again, kinds()) == text, "writing again gives the same bytes");
    return 0;
}
