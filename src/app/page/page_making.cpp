#include "app/page/page_making.h"

#include "app/command_line/output_path.h"
#include "app/process/assets_folder.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "core/files/file_io.h"
#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "persist/creature/page_document.h"
#include "persist/page/run_page.h"

#include <fmt/core.h>

#include <system_error>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostPageCreatures = 24;

// Of a creature without a name, that of its file.
std::string label_of(const std::string& file, const Genome& genome) {
    if (!genome.name.empty()) return genome.name;
    const std::string name = std::filesystem::path(file).filename().string();
    return capitalized(name.substr(0, name.find('.')));
}

}  // namespace

// The installed engine lies beside the scripts, that of a build in the build's folder.
PageParts page_parts() {
    PageParts parts;
    parts.version = CAMBRIAN_VERSION;
    parts.folder = assets_folder() / "page";
    const std::filesystem::path built = CAMBRIAN_ENGINE_FOLDER;
    std::error_code failure;
    const bool installed = std::filesystem::exists(parts.folder / "cambrian.wasm", failure);
    const std::filesystem::path& folder = installed ? parts.folder : built;
    parts.engine = folder / "cambrian.wasm";
    parts.licences = folder / "licences.txt";
    return parts;
}

bool is_page_name(const std::filesystem::path& path) {
    return path.extension() == kPageEnding;
}

ExitStatus write_page(const PageContent& content, const std::filesystem::path& path,
                      const EvolutionKinds& kinds) {
    const PageParts parts = page_parts();
    const Result<std::string> page = make_page(content, parts, kinds);
    if (!page) return fail(page.error(), ExitStatus::kFailed);
    const Status written = write_file(path, *page);
    if (!written) return fail(written.error(), ExitStatus::kFailed);
    std::error_code failure;
    if (!std::filesystem::exists(parts.engine, failure))
        say("no engine is built, so the page plays recorded motions only; `sh "
            "third_party/bootstrap.sh engine` builds it");
    return print_result_line(fmt::format("{}: {} kB", path.string(), page->size() / 1000));
}

ExitStatus make_page_of(const std::vector<std::string>& sources, const std::string& out,
                        const CommandFiles& files, const EvolutionKinds& kinds) {
    const auto path = output_path(out, "", files);
    if (!path) return fail(path.error());
    if (sources.size() == 1 && is_experiment_name(sources.front())) {
        LongWork work;
        work.begin("computing champions", static_cast<double>(kPageChampions), "creatures");
        const Result<PageContent> content = content_of_run(sources.front(), kinds, work.watch());
        return content ? write_page(*content, *path, kinds) : fail(content.error());
    }
    if (sources.size() > kMostPageCreatures)
        return fail({fmt::format("{} creatures; a page has at most {}", sources.size(),
                                 kMostPageCreatures)});
    PageContent content;
    for (const std::string& source : sources) {
        Result<CreatureDocument> document = load_creature(source, kinds);
        if (!document) return fail(document.error());
        say_of(source, document->warnings);
        const std::string label = label_of(source, document->genome());
        content.creatures.push_back({.document = *std::move(document), .label = label});
    }
    content.title =
        sources.size() == 1 ? content.creatures.front().label : counted(sources.size(), "creature");
    return write_page(content, *path, kinds);
}

}  // namespace cambrian
