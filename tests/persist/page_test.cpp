#include "core/files/file_io.h"
#include "persist/creature/page_document.h"
#include "persist/page/page_file.h"
#include "persist/sample_creature.h"
#include "support/catch.h"
#include "support/temporary_directory.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

PageParts without_engine() {
    return {
        .version = "1", .folder = CAMBRIAN_SOURCE_DIR "/assets/page", .engine = {}, .licences = {}};
}

std::string page_of(const CreatureDocument& document) {
    const PageContent content{.title = "<b>\"Walker\" & co.</b>",
                              .creatures = {{.document = document, .label = "one"}}};
    return make_page(content, without_engine(), kinds()).value();
}

CreatureDocument named(const std::string& name) {
    CreatureDocument document = parse_creature(sample_text(), "", kinds()).value();
    Individual individual = *document.creature.individual;
    Genome genome = *individual.genome;
    genome.name = name;
    individual.genome = std::make_shared<const Genome>(std::move(genome));
    document.creature.individual = std::make_shared<const Individual>(std::move(individual));
    return document;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

}  // namespace

TEST_CASE("a page opens as the creature file it carries does", "[persist][page]") {
    const TemporaryDirectory folder;
    const CreatureDocument document = parse_creature(sample_text(), "", kinds()).value();
    const auto path = folder.path() / "a.html";
    REQUIRE(write_file(path, page_of(document)));
    const auto loaded = load_creature(path, kinds());
    REQUIRE(loaded);
    CHECK(write_creature(*loaded, kinds()) == write_creature(document, kinds()));
}

TEST_CASE("a name cannot end the element that holds it", "[persist][page]") {
    const std::string name = "</script><script>alert(1)</script>";
    const CreatureDocument document = named(name);
    const std::string page = page_of(document);
    CHECK(count_of(page, "<script>alert") == 0);
    CHECK(count_of(page, "<b>\"Walker\"") == 0);
    CHECK(count_of(page, "&lt;b&gt;&quot;Walker&quot; &amp; co.&lt;/b&gt;") == 3);
    CHECK(count_of(page, "</script>") == count_of(page, "<script"));
    const auto inside = parse_creature(page_document(page, "a").value(), "a", kinds());
    REQUIRE(inside);
    CHECK(inside->genome().name == document.genome().name);
}

TEST_CASE("a page needs no network", "[persist][page]") {
    const std::string page = page_of(parse_creature(sample_text(), "", kinds()).value());
    for (const char* address : {"http://", "https://", "src=", "@import", "url("})
        CHECK(count_of(page, address) == 0);
    CHECK_THAT(page, Catch::Contains("default-src 'none'"));
}

TEST_CASE("what is no page with a creature is refused in a sentence", "[persist][page]") {
    const std::string page = page_of(parse_creature(sample_text(), "", kinds()).value());
    const std::size_t creature = page.find("id=\"cambrian-creature\"");
    REQUIRE(creature != std::string::npos);
    const std::pair<std::string, const char*> cases[] = {
        {"<!doctype html><p>Nothing</p>", "a page without a creature inside"},
        {page.substr(0, creature + 40), "the creature inside is cut off"},
        {page.substr(0, creature + 23) + std::string(5'000'000, ' ') + "</script>",
         "the creature inside is too large"},
        {std::string(kMaxPageBytes + 1, ' '), "a page of over 64 MB"}};
    for (const auto& [bytes, reason] : cases) {
        const auto refused = page_document(bytes, "x.html");
        REQUIRE_FALSE(refused);
        CHECK_THAT(refused.error().message, Catch::StartsWith("x.html: ") &&
                                                Catch::Contains(reason) &&
                                                Catch::Contains("expected a page"));
    }
}

TEST_CASE("what makes a file a page is its beginning, not its name", "[persist][page]") {
    CHECK(is_page("<!DOCTYPE html>"));
    CHECK(is_page("<!doctype html lang"));
    CHECK_FALSE(is_page("<!doctype"));
    CHECK_FALSE(is_page("{\"format\": 1}"));
    CHECK_FALSE(is_page(""));
}
