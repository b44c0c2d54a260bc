#include "studio/files/saved_pages.h"

#include "core/files/file_io.h"
#include "persist/page/run_page.h"

#include <utility>

namespace cambrian {
namespace {

Status write_page_content(const std::filesystem::path& path, const PageContent& content,
                          const PageParts& parts, const EvolutionKinds& kinds,
                          const TrialWatch& watch) {
    const Result<std::string> page = make_page(content, parts, kinds);
    if (!page) return page.error();
    if (watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
    return write_file(path, *page);
}

}  // namespace

Status write_creature_page(CreaturePage page, const PageParts& parts, const EvolutionKinds& kinds,
                           const TrialWatch& watch) {
    complete_score(page.document, kinds, watch.stop);
    return write_page_content(page.path, content_of_creature(std::move(page.document), page.title),
                              parts, kinds, watch);
}

Status write_run_page(const RunPage& page, const PageParts& parts, const EvolutionKinds& kinds,
                      const TrialWatch& watch) {
    const std::filesystem::path run = page.run->path();
    if (run.empty()) return Error{"this run has no file yet; save the experiment (Ctrl+K)"};
    Result<PageContent> content = content_of_run(run, kinds, watch);
    if (!content) return content.error();
    content->title = page.title;
    return write_page_content(page.path, *content, parts, kinds, watch);
}

}  // namespace cambrian
