#include "studio/help/help_index.h"

#include "core/files/file_io.h"
#include "core/text/pretty_text.h"
#include "persist/creature/png_file.h"

#include <algorithm>
#include <system_error>

namespace cambrian {
namespace {

constexpr std::size_t kMostPageBytes = 1'000'000;
constexpr std::size_t kMostPictureBytes = 20'000'000;

constexpr const char* kFirstSteps = R"(# First steps

Press **Evolve**: creatures are bred, tried in their world and selected, generation after
generation. The viewport shows the best of the newest generation.

Change the world or the rules on the left at any time. The creature on display feels it at once, the
next generation evolves under it, and the timeline marks it.

Take hold of a creature with the mouse; drag with the right button to look around, scroll to come
closer. Drag over the timeline to watch earlier champions; a star keeps a creature of the population
when its generation has passed.

Press `H` to [select by hand](hand_picking.md): click the creatures you like in the grid and press
`Enter` to breed the next one from them. `Backspace` goes back; nothing is lost.

Press `Shift+D` to [draw a creature](drawing.md) with the mouse, give it a rhythm and evolve it.

Press `Ctrl+N` to begin a [preserve](preserve.md): a closed world in which creatures feed, breed and
die by themselves.

- [The first minute](first_minute.md) tells what the window shows while a run begins: founders, the
  rival, suggestions, and the start page with earlier runs.
- The *?* in the corner of each panel opens its page: [settings](experiment.md),
  [viewport](viewport.md), [inspector](inspector.md), [timeline](timeline.md).
- [Keys](keys.md) lists what the keyboard does. Everything of the first minute works without a
  mouse: `Space` evolves, `/` finds a setting, `Ctrl+S` saves the creature, `Ctrl+Q` quits.
- *File*, *Samples* holds creatures that were evolved before; each moves while the pointer is on it.
)";

constexpr const char* kAbout = R"(# About Cambrian

A studio in which creatures evolve. Version )" CAMBRIAN_VERSION
                               R"(.

Creatures are directed graphs of parts, joints, sensors and neurons after Karl Sims, *Evolving
Virtual Creatures*, SIGGRAPH 1994. Their physics is computed in two dimensions by articulated bodies
with contact and friction; the same seed gives the same bits everywhere.

The licence of Cambrian is in its file `LICENSE`.

## Made with

| library | for | licence |
|---|---|---|
| Dear ImGui | controls | MIT |
| GLFW | the window | zlib |
| glad | loading OpenGL | MIT |
| stb | pictures | MIT or public domain |
| Eigen | vectors and matrices | MPL 2.0 |
| nlohmann/json | creature files | MIT |
| toml++ | settings files | MIT |
| SQLite | experiment and preserve files | public domain |
| libpng | pictures and cards | libpng |
| libdeflate | compression | MIT |
| {fmt} | text | MIT |
| CLI11 | the command line | BSD, 3 clauses |
| libnats | several machines, where built with it | Apache 2.0 |
| Fontconfig | typefaces of other scripts | HPND |
| XCB | the clipboard | MIT |
| Inter | the typeface, where installed | SIL Open Font License 1.1 |

Their sources: `github.com/ocornut/imgui`, `glfw.org`, `github.com/Dav1dde/glad`,
`github.com/nothings/stb`, `eigen.tuxfamily.org`, `github.com/nlohmann/json`,
`github.com/marzer/tomlplusplus`, `sqlite.org`, `libpng.org`, `github.com/ebiggers/libdeflate`,
`github.com/fmtlib/fmt`, `github.com/CLIUtils/CLI11`,
`github.com/nats-io/nats.c`, `fontconfig.org`, `xcb.freedesktop.org`, `rsms.me/inter`.
)";

std::vector<HelpPage> read_folder(const std::filesystem::path& folder) {
    std::vector<HelpPage> pages;
    std::error_code error;
    auto entry = std::filesystem::directory_iterator(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        if (entry->path().extension() != ".md") continue;
        // A file without a title is included by another page and is not a page itself.
        const auto text = read_file(entry->path(), kMostPageBytes);
        if (text && text->starts_with("# "))
            pages.push_back(help_page(entry->path().stem().string(), *text));
    }
    std::sort(pages.begin(), pages.end(),
              [](const HelpPage& a, const HelpPage& b) { return a.title < b.title; });
    return pages;
}

bool is_page(const std::vector<HelpPage>& pages, const std::string& link) {
    const std::filesystem::path path(link.substr(0, link.find('#')));
    return path.extension() == ".md" &&
           std::any_of(pages.begin(), pages.end(),
                       [&](const HelpPage& page) { return page.name == path.stem().string(); });
}

// Only links to pages can be followed; those to other files become their names.
void name_other_files(std::vector<HelpPage>& pages) {
    for (HelpPage& page : pages) {
        for (MarkdownBlock& block : page.blocks) {
            for (TextSpan& span : block.line) {
                if (span.link.empty() || is_page(pages, span.link)) continue;
                span.text += " (" + span.link + ")";
                span.link.clear();
            }
        }
    }
}

}  // namespace

const HelpPage* HelpIndex::open_page() const {
    const auto page = std::find_if(pages.begin(), pages.end(),
                                   [&](const HelpPage& each) { return each.name == open; });
    return page == pages.end() ? nullptr : &*page;
}

HelpPage help_page(const std::string& name, std::string_view text) {
    HelpPage page{name, capitalized(name), parse_markdown(text)};
    if (page.blocks.empty() || page.blocks.front().kind != BlockKind::kHeading) return page;
    page.title.clear();
    for (const TextSpan& span : page.blocks.front().line)
        page.title += span.text;
    return page;
}

std::vector<HelpPage> read_help(const std::filesystem::path& folder, std::string_view keys,
                                std::string_view words) {
    std::vector<HelpPage> pages = {help_page(kFirstStepsPage, kFirstSteps),
                                   help_page(kKeysPage, keys), help_page(kWordsPage, words)};
    for (HelpPage& page : read_folder(folder))
        pages.push_back(std::move(page));
    pages.push_back(help_page(kAboutPage, kAbout));
    name_other_files(pages);
    return pages;
}

std::vector<HelpPicture> read_pictures(const std::filesystem::path& folder, const HelpPage& page) {
    std::vector<HelpPicture> pictures;
    for (const MarkdownBlock& block : page.blocks) {
        if (block.kind != BlockKind::kPicture || block.picture) continue;
        const auto bytes = read_file(folder / block.target, kMostPictureBytes);
        if (!bytes) continue;
        Result<Image> image = decode_png(*bytes);
        if (!image) continue;
        pictures.push_back(
            {page.name, block.target, std::make_shared<const Image>(*std::move(image))});
    }
    return pictures;
}

void add_pictures(HelpIndex& index, const std::vector<HelpPicture>& pictures) {
    for (HelpPage& page : index.pages) {
        for (MarkdownBlock& block : page.blocks) {
            for (const HelpPicture& each : pictures) {
                if (each.page == page.name && each.target == block.target)
                    block.picture = each.image;
            }
        }
    }
}

}  // namespace cambrian
