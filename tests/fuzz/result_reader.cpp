// Fuzzes results of a cluster's units and its members' announcements: the reader gives values or a
// message.

#include "cluster/messages/hello_text.h"
#include "cluster/messages/result_text.h"
#include "cluster/messages/unit_text.h"
#include "cluster/messages/work_queue.h"
#include "fuzz/fuzz_target.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

void read_result(std::string_view text) {
    const auto unit = parse_unit_result(text);
    if (!unit) {
        promise(unit.error().message.starts_with("cambrian-result: "),
                "a refusal names the format");
        return;
    }
    promise(unit->results.size() <= kMostUnitCreatures, "a unit has so many results at most");
    for (const SlotResult& each : unit->results)
        promise(each.result.reason.size() <= kLongestResultReason, "reasons are short");
    const std::string written = write_unit_result(*unit);
    const auto again = parse_unit_result(written);
    promise(again.has_value(), "what is written can be read");
    promise(write_unit_result(*again) == written, "writing again gives the same bytes");
}

void read_hello(std::string_view text) {
    const auto hello = parse_hello(text);
    if (!hello) {
        promise(hello.error().message.starts_with("cambrian-hello: "),
                "a refusal names the format");
        return;
    }
    promise(hello->name.size() <= 43, "names are short");
    const std::string written = hello_text(*hello);
    promise(parse_hello(written).has_value(), "what is written can be read");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    read_result(text_of(data, size));
    read_hello(text_of(data, size));
    return 0;
}
