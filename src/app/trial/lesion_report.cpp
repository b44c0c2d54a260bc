#include "app/trial/lesion_report.h"

#include "core/text/counted.h"
#include "core/text/number_text.h"
#include "core/text/shown_text.h"
#include "persist/json/json_text.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace cambrian {
namespace {

std::string scores_range_text(const std::vector<double>& scores) {
    const auto [least, most] = std::minmax_element(scores.begin(), scores.end());
    return fmt::format("{:.3g} to {:.3g}", *least, *most);
}

// Example: "   3 %  0.031 (0.02 to 0.04)  joint of part 2 locked".
std::string row_text(const LesionRow& row, const LesionReport& report) {
    const double whole = report.table.intact.left;
    const std::string share =
        whole > 0.0 ? fmt::format("{:>4.0f} %", 100.0 * std::max(0.0, row.left) / whole) : "   - %";
    return fmt::format("\n{}  {:<28}  {}", share,
                       fmt::format("{:.3g} ({})", row.left, scores_range_text(row.scores)),
                       words_of(row.lesions, report.intact, report.kinds));
}

std::vector<LesionRow> all_rows(const LesionTable& table) {
    std::vector<LesionRow> rows = table.rows;
    rows.insert(rows.end(), table.pairs.begin(), table.pairs.end());
    return rows;
}

std::string row_json(const LesionRow& row, const LesionReport& report) {
    std::vector<std::string> scores, kinds;
    for (const double score : row.scores)
        scores.push_back(real_text(score));
    for (const Lesion& lesion : row.lesions)
        kinds.push_back(quoted_text(lesion_id(lesion.kind)));
    return json_object({{"lost", quoted_text(words_of(row.lesions, report.intact, report.kinds))},
                        {"kinds", json_list(kinds)},
                        {"fitness", real_text(row.left)},
                        {"scores", json_list(scores)}});
}

}  // namespace

std::string lesions_text(const LesionReport& report) {
    const LesionRow& intact = report.table.intact;
    std::string text =
        fmt::format("intact: {:.4g} {}, the median of {} ({})", intact.left, report.unit,
                    counted(intact.scores.size(), "world"), scores_range_text(intact.scores));
    for (const LesionRow& row : report.table.rows)
        text += row_text(row, report);
    if (!report.table.pairs.empty()) text += "\npairs of the worst:";
    for (const LesionRow& row : report.table.pairs)
        text += row_text(row, report);
    return text;
}

std::string lesions_csv(const LesionReport& report) {
    std::string text = "lost,share,median,least,greatest\n";
    const double whole = report.table.intact.left;
    for (const LesionRow& row : all_rows(report.table)) {
        const auto [least, most] = std::minmax_element(row.scores.begin(), row.scores.end());
        text += fmt::format("{},{},{},{},{}\n",
                            csv_cell(words_of(row.lesions, report.intact, report.kinds)),
                            whole > 0.0 ? real_text(row.left / whole) : "", real_text(row.left),
                            real_text(*least), real_text(*most));
    }
    return text;
}

std::string lesions_json(const LesionReport& report, const PrunedCreature* pruned) {
    std::vector<std::string> rows, removed;
    for (const LesionRow& row : all_rows(report.table))
        rows.push_back(row_json(row, report));
    std::string twin = "null";
    if (pruned != nullptr) {
        for (const std::string& gene : pruned->removed)
            removed.push_back(quoted_text(gene));
        twin = json_object({{"before", real_text(pruned->before)},
                            {"after", real_text(pruned->after)},
                            {"removed", json_list(removed)}});
    }
    return json_object({{"unit", quoted_text(report.unit)},
                        {"intact", real_text(report.table.intact.left)},
                        {"lesions", json_list(rows)},
                        {"pruned", twin}});
}

std::string pruning_text(const PrunedCreature& pruned, const std::string& unit) {
    return fmt::format("without {} that cost nothing: {:.4g} of {:.4g} {}",
                       counted(pruned.removed.size(), "gene"), pruned.after, pruned.before, unit);
}

}  // namespace cambrian
