// Fuzzes the stored arrangement of the studio: any text gives an arrangement that is written and
// read again without change.

#include "fuzz/fuzz_target.h"
#include "studio/preferences.h"

using namespace cambrian;
using namespace cambrian::test;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ViewState view = parse_view(text_of(data, size));
    const std::string text = write_view(view);
    promise(write_view(parse_view(text)) == text, "writing again gives the same bytes");
    return 0;
}
