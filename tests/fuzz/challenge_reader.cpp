// Fuzzes challenge files: the reader gives a challenge, which is written and read again without
// change, or a message. Every challenge is a settings file, too.

#include "fuzz/fuzz_target.h"
#include "persist/settings/challenge_file.h"
#include "persist/settings/settings_file.h"
#include "support/kinds.h"

using namespace cambrian;
using namespace cambrian::test;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto challenge = parse_challenge(text_of(data, size), "input", kinds());
    if (!challenge) {
        promise(challenge.error().message.starts_with("input: "), "a refusal names the file");
        return 0;
    }
    promise(parse_settings(text_of(data, size), "input", kinds()).has_value(),
            "a challenge is a settings file");
    const std::string text = write_challenge(*challenge, kinds());
    const auto again = parse_challenge(text, "again", kinds());
    promise(again.has_value(), "what is written can be read");
    promise(write_challenge(*again, kinds()) == text, "writing again gives the same bytes");
    return 0;
}
