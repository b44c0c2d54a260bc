// Fuzzes units of a cluster: the reader gives requests that can be evaluated, or a message. Bytes
// after the first line are tried as they are and deflated, since nearly every change of deflated
// bytes fails at the first check. Messages to a separate process contain a unit, too.

#include "cluster/messages/unit_text.h"
#include "cluster/units/unit_child.h"
#include "core/deflated_text.h"
#include "fuzz/fuzz_target.h"
#include "support/kinds.h"

#include <string>

using namespace cambrian;
using namespace cambrian::test;

namespace {

void read_and_write_again(std::string_view body) {
    const auto outline = parse_unit_outline(body);
    const auto unit = UnitReader(kinds()).read(body);
    if (!unit) {
        promise(unit.error().message.starts_with("cambrian-unit: "), "a refusal names the format");
        return;
    }
    promise(outline.has_value(), "a unit that can be read has an outline");
    promise(outline->terms == unit->terms, "the outline says what the unit says");
    promise(!unit->requests.empty() && unit->requests.size() <= kMostUnitCreatures,
            "a unit has some creatures");
    UnitWriter writer(kinds());
    const std::string text = writer.write(unit->terms, unit->requests);
    const auto again = UnitReader(kinds()).read(text);
    promise(again.has_value(), "what is written can be read");
    promise(writer.write(again->terms, again->requests) == text,
            "writing again gives the same bytes");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = text_of(data, size);
    read_and_write_again(bytes);
    const std::size_t line = bytes.find('\n');
    if (line != std::string_view::npos) {
        Deflater deflater;
        std::string body(bytes.substr(0, line + 1));
        read_and_write_again(body.append(deflater.deflate(bytes.substr(line + 1))));
    }
    if (bytes.starts_with("{ \"format\": \"cambrian-question\""))
        promise(!answer_question(bytes.substr(0, bytes.size() / 2), kinds()),
                "half a question has no answer");
    return 0;
}
