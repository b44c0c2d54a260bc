// The arrangement the studio remembers: any text gives one that is written and read again as it
// was.

#include "fuzz/fuzz_target.h"
#include "studio/remembered.h"

using namespace cambrian;
using namespace cambrian::test;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ViewState view = parse_view(text_of(data, size));
    const std::string text = write_view(view);
    promise(write_view(parse_view(text)) == text, "writing again gives the same bytes");
    return 0;
}
