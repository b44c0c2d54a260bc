#include "studio/actions/palette_lines.h"

#include "core/text/search_words.h"
#include "evolution/fields/setting_words.h"
#include "studio/actions/action.h"
#include "studio/experiment/setting_groups.h"
#include "studio/experiment/settings_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace cambrian {
namespace {

constexpr int kMostRank = 5;
constexpr std::size_t kMostHelpLines = 40;
constexpr std::size_t kExcerpt = 90;  // bytes

bool begins_word(const std::string& text, std::size_t at) {
    return at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
}

// Returns where the first of the words is if the text has all of them in their order. Each may be
// anywhere or must begin a word.
std::optional<std::size_t> find_in_order(const std::vector<std::string>& words,
                                         const std::string& text, bool at_beginnings) {
    std::optional<std::size_t> first;
    std::size_t from = 0;
    for (const std::string& word : words) {
        std::size_t at = text.find(word, from);
        while (at_beginnings && at != std::string::npos && !begins_word(text, at))
            at = text.find(word, at + 1);
        if (at == std::string::npos) return {};
        if (!first) first = at;
        from = at + word.size();
    }
    return first;
}

std::vector<std::string> as_phrase(const std::vector<std::string>& words) {
    return {fmt::format("{}", fmt::join(words, " "))};
}

// Returns the part of a text around where the words are, in one line.
std::string excerpt(const std::string& text, const std::vector<std::string>& words) {
    const std::string small = small_letters(text);
    std::size_t at = 0;
    for (const auto& [sought, at_beginnings] :
         {std::pair{words, false}, std::pair{words, true}, std::pair{as_phrase(words), true}})
        at = find_in_order(sought, small, at_beginnings).value_or(at);
    // Begins with the line or the sentence, if that is near, or else with a word.
    const std::size_t line = text.rfind('\n', at);
    const std::size_t sentence = text.rfind(". ", at);
    std::size_t from = line == std::string::npos ? 0 : line + 1;
    if (sentence != std::string::npos) from = std::max(from, sentence + 2);
    from = std::min(from, at);
    if (at - from > kExcerpt / 3) from = text.rfind(' ', at - kExcerpt / 4) + 1;
    std::string part = text.substr(from, 2 * kExcerpt);
    while (!part.empty() && (static_cast<unsigned char>(part.front()) & 0xC0U) == 0x80U)
        part.erase(0, 1);
    std::replace(part.begin(), part.end(), '\n', ' ');
    return part;
}

struct Ranked {
    int rank;
    PaletteLine line;
};

void add_actions(std::string_view words, const FrameContext& frame, std::vector<Ranked>& lines) {
    for (const FoundAction& found : present_actions(frame)) {
        const Action& action = *found.action;
        if (action.id == "palette" || action.id == "close") continue;
        const auto rank = match_rank(words, action.label, action.help);
        if (!rank) continue;
        const int last = found.enabled ? 0 : kMostRank + 1;
        lines.push_back(
            {*rank + last,
             {action.label, action.help, present_keys(action, frame), found.enabled, action.ask}});
    }
}

void add_settings(std::string_view words, const FrameContext& frame, std::vector<Ranked>& lines) {
    if (frame.preserve != nullptr) return;
    ExperimentSettings draft = frame.experiment.editor.draft();
    for (const SettingField& field : frame.experiment.fields) {
        if (field.applies && !field.applies(draft)) continue;
        const std::string title = plain_label(field);
        const std::string group = group_title(shown_table(field));
        const auto rank = match_rank(words, title,
                                     fmt::format("{} {} {}\n{}\n{}", field.label, field.key, group,
                                                 plain_help(field), field.help));
        if (!rank) continue;
        const std::string value = value_text(field, field.at(draft));
        lines.push_back({*rank,
                         {title, fmt::format("{}: {}", group, value), "setting", true,
                          [path = path_of(field)](const FrameContext&, Requests& out) {
                              out.ask(ShowSetting{path});
                          }}});
    }
}

// Adds the first place that matches below each heading.
void add_help(std::string_view words, const std::vector<HelpPlace>& help,
              std::vector<Ranked>& lines) {
    const std::vector<std::string> sought = search_words(words);
    const HelpPlace* before = nullptr;
    std::size_t count = 0;
    for (const HelpPlace& place : help) {
        const bool repeated =
            before != nullptr && before->page == place.page && before->heading == place.heading;
        if (repeated || count >= kMostHelpLines) continue;
        const auto rank = match_rank(words, place.heading, place.text);
        // The keys of actions are found with these.
        if (!rank || (place.page == kKeysPage && *rank > 2)) continue;
        before = &place;
        ++count;
        std::string where = place.heading == place.title ? "" : place.title;
        if (place.text != place.heading)
            where += (where.empty() ? "" : ": ") + excerpt(place.text, sought);
        lines.push_back(
            {*rank,
             {place.heading, where, "help", true,
              [page = place.page, block = place.block](const FrameContext&, Requests& out) {
                  out.ask(ShowHelp{page, block});
              }}});
    }
}

}  // namespace

std::optional<int> match_rank(std::string_view words, std::string_view title,
                              std::string_view text) {
    const std::vector<std::string> sought = search_words(words);
    if (sought.empty()) return 0;
    const std::string small = small_letters(std::string(title));
    if (const auto at = find_in_order(sought, small, true)) return *at == 0 ? 0 : 1;
    if (find_in_order(sought, small, false)) return 2;
    const std::string all = small_letters(std::string(text));
    if (find_in_order(as_phrase(sought), all, true)) return 3;
    if (find_in_order(sought, all, true)) return 4;
    if (find_in_order(sought, all, false)) return 5;
    return {};
}

std::vector<PaletteLine> palette_lines(std::string_view words, const FrameContext& frame,
                                       const std::vector<HelpPlace>& help) {
    std::vector<Ranked> ranked;
    add_actions(words, frame, ranked);
    if (!search_words(words).empty()) {
        add_settings(words, frame, ranked);
        add_help(words, help, ranked);
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const Ranked& a, const Ranked& b) { return a.rank < b.rank; });
    std::vector<PaletteLine> lines;
    for (Ranked& each : ranked)
        lines.push_back(std::move(each.line));
    return lines;
}

}  // namespace cambrian
