#include "comparison/board_text.h"

#include "core/text/code_points.h"
#include "core/text/counted.h"
#include "core/text/shown_score.h"
#include "evolution/settings/chance.h"
#include "persist/creature/page_document.h"
#include "persist/text/web_text.h"

#include <fmt/core.h>

#include <cctype>
#include <system_error>

namespace cambrian {
namespace {

constexpr const char* kBoardHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1">
<title>{0}</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
<style>
:root{{color-scheme:light dark;--ink:#1d2530;--paper:#f4f1ea;--soft:#626b77;--card:#fffdf8;--warm:#b9642a}}
@media(prefers-color-scheme:dark){{:root{{--ink:#e6e9ee;--paper:#14181e;--soft:#98a2b0;--card:#1c222a;--warm:#e0935a}}}}
*{{box-sizing:border-box}}body{{margin:0;font:15px/1.45 system-ui,sans-serif;color:var(--ink);background:var(--paper)}}
main{{max-width:860px;margin:0 auto;padding:20px}}h1{{font-size:26px;margin:0 0 4px;overflow-wrap:anywhere}}p{{margin:0 0 12px;color:var(--soft)}}
table{{width:100%;border-collapse:separate;border-spacing:0 8px;font-variant-numeric:tabular-nums}}th{{text-align:left;color:var(--soft);font-weight:500;padding:0 12px}}
td{{background:var(--card);padding:10px 12px;overflow-wrap:anywhere}}td:first-child{{border-radius:10px 0 0 10px;font-size:20px;color:var(--soft);width:56px}}td:last-child{{border-radius:0 10px 10px 0}}
img{{display:block;width:135px;border-radius:6px}}.score{{font-size:20px;font-weight:600;color:var(--warm);white-space:nowrap}}a{{color:inherit}}b{{font-size:17px}}small,li{{color:var(--soft)}}code{{font-size:13px}}
</style></head><body><main>
)";

// Example: "Walking · seed 7 · 20000 trials · simulator 1.3".
std::string facts_of_challenge(const Challenge& challenge, const EvolutionKinds& kinds) {
    const ExperimentSettings& settings = challenge.settings;
    const GoalKind* goal = kinds.goals.find(settings.goal);
    return fmt::format("{} · seed {} · {} trials · simulator {}",
                       goal == nullptr ? settings.goal : goal->label, settings.seed,
                       settings.max_evaluations, challenge.table.simulator);
}

std::string how_it_is_ranked(const Challenge& challenge) {
    return has_chance(challenge.settings.world)
               ? fmt::format(
                     "Every creature was computed again and compared with its file bit by "
                     "bit, then ranked by trials of its own, with seed {}.",
                     challenge.table.held_out_seed)
               : "Every creature was computed again and compared with its file bit by bit.";
}

std::string challenge_title(const Challenge& challenge) {
    return "Challenge: " + on_one_line(challenge.table.name);
}

std::string board_unit(const ChallengeBoard& board, const EvolutionKinds& kinds) {
    return goal_unit(board.challenge.settings.goal, kinds.goals);
}

// The address of a page seen from a folder; empty for other files.
std::string link_to(const std::filesystem::path& file, const std::filesystem::path& folder) {
    if (file.extension() != kPageEnding) return {};
    std::error_code unknown;
    const auto base = folder.empty() ? std::filesystem::path(".") : folder;
    const std::string path = std::filesystem::relative(file, base, unknown).generic_string();
    std::string address;
    for (const char letter : path) {
        const auto byte = static_cast<unsigned char>(letter);
        const bool plain = std::isalnum(byte) != 0 || letter == '/' || letter == '.' ||
                           letter == '-' || letter == '_';
        address += plain ? std::string(1, letter) : fmt::format("%{:02X}", byte);
    }
    return address;
}

// Escapes what Markdown and the HTML in it give a meaning.
std::string markdown_text(const std::string& text) {
    std::string escaped_text;
    for (const char letter : on_one_line(text)) {
        if (std::string_view("\\`*_{}[]<>()#+!|~&").find(letter) != std::string_view::npos)
            escaped_text += '\\';
        escaped_text += letter;
    }
    return escaped_text;
}

}  // namespace

std::string board_markdown(const ChallengeBoard& board, const std::filesystem::path& folder,
                           const EvolutionKinds& kinds) {
    const std::string unit = board_unit(board, kinds);
    std::string text = fmt::format(
        "# {}\n\n{}\n\n{}\n\n| rank | creature | score | parts | file |\n"
        "|---:|---|---:|---:|---|\n",
        markdown_text(challenge_title(board.challenge)), facts_of_challenge(board.challenge, kinds),
        how_it_is_ranked(board.challenge));
    for (std::size_t i = 0; i < board.ranked.size(); ++i) {
        const BoardEntry& entry = board.ranked[i];
        const std::string link = link_to(entry.file, folder);
        const std::string name = markdown_text(entry.name);
        text += fmt::format("| {} | {} | {} | {} | {} |\n", i + 1,
                            link.empty() ? name : fmt::format("[{}]({})", name, link),
                            shown_score(entry.score, unit), entry.parts,
                            markdown_text(entry.file.filename().string()));
    }
    if (!board.refused.empty()) text += "\nRefused:\n\n";
    for (const BoardEntry& entry : board.refused)
        text += fmt::format("- {}: {}\n", markdown_text(entry.file.filename().string()),
                            markdown_text(entry.refusal));
    return text;
}

std::string board_html(const ChallengeBoard& board, const std::filesystem::path& folder,
                       const std::vector<std::string>& cards, const EvolutionKinds& kinds) {
    const std::string unit = board_unit(board, kinds);
    const std::string title = html_text(challenge_title(board.challenge));
    std::string text = fmt::format(kBoardHead, title);
    text += fmt::format(
        "<h1>{}</h1><p>{}<br>{}</p>\n<table><tr><th>rank</th><th></th><th>creature"
        "</th><th>score</th><th>parts</th></tr>\n",
        title, html_text(facts_of_challenge(board.challenge, kinds)),
        html_text(how_it_is_ranked(board.challenge)));
    for (std::size_t i = 0; i < board.ranked.size(); ++i) {
        const BoardEntry& entry = board.ranked[i];
        const std::string link = link_to(entry.file, folder);
        std::string name = fmt::format("<b>{}</b>", html_text(on_one_line(entry.name)));
        if (!link.empty()) name = fmt::format("<a href=\"{}\">{}</a>", html_text(link), name);
        const std::string card =
            i < cards.size()
                ? fmt::format("<img alt=\"Card of {}\" src=\"data:image/png;base64,{}\">",
                              html_text(on_one_line(entry.name)), base64(cards[i]))
                : "";
        text += fmt::format(
            "<tr><td>{}</td><td>{}</td><td>{}<br><small>{}</small></td><td "
            "class=\"score\">{}</td><td>{}</td></tr>\n",
            i + 1, card, name, html_text(on_one_line(entry.file.filename().string())),
            html_text(shown_score(entry.score, unit)), entry.parts);
    }
    text += "</table>\n";
    if (!board.refused.empty()) {
        text += "<h2>Refused</h2><ul>\n";
        for (const BoardEntry& entry : board.refused)
            text += fmt::format("<li>{}: {}</li>\n",
                                html_text(on_one_line(entry.file.filename().string())),
                                html_text(on_one_line(entry.refusal)));
        text += "</ul>\n";
    }
    return text +
           "<p><small>Made by Cambrian. Each card has its creature inside: drop it on the "
           "window, or run <code>cambrian verify</code>.</small></p>\n</main></body></html>\n";
}

}  // namespace cambrian
