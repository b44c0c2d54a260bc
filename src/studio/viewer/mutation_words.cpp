#include "studio/viewer/mutation_words.h"

#include "core/text/pretty_text.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

namespace cambrian {

std::string operator_words(const MutationRecord& mutation, const MutationRegistry& kinds) {
    if (mutation.operator_id == "edited") return "Edited by hand";
    const MutationKind* kind = kinds.find(mutation.operator_id);
    return kind == nullptr ? capitalized(mutation.operator_id) : kind->label;
}

std::string change_words(const MutationRecord& mutation) {
    if (mutation.from.empty() || mutation.to.empty()) return mutation.from + mutation.to;
    return fmt::format("{} → {}", mutation.from, mutation.to);
}

std::string mutation_words(const MutationRecord& mutation, const MutationRegistry& kinds) {
    return fmt::format("{}: {} {}", operator_words(mutation, kinds), mutation.place,
                       change_words(mutation));
}

void draw_mutation(const MutationRecord& mutation, const MutationRegistry& kinds) {
    ImGui::Dummy({0, px(1)});
    const float room = ImGui::GetContentRegionAvail().x;
    ImGui::TextUnformatted(fit_text(operator_words(mutation, kinds), room).c_str());
    const std::string change = change_words(mutation);
    const float together = ImGui::CalcTextSize((mutation.place + change).c_str()).x + px(16);
    if (together <= room) return fact(mutation.place, change);
    {
        const WithTextColor color(colors().muted);
        ImGui::TextUnformatted(fit_text(mutation.place, room).c_str());
    }
    tooltip(mutation.place);
    ImGui::TextUnformatted(fit_text(change, room).c_str());
    tooltip(change);
}

}  // namespace cambrian
