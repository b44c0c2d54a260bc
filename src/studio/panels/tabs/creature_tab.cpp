#include "studio/panels/tabs/creature_tab.h"

#include "studio/origin_words.h"
#include "studio/text.h"
#include "studio/widgets.h"

namespace cambrian {
namespace {

void section(const char* title) {
    ImGui::Dummy({0, px(4)});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddLine(at, {at.x + width, at.y}, paint(colors().border));
    ImGui::Dummy({0, px(2)});
    const WithFont font(ui().fonts.strong);
    ImGui::TextUnformatted(title);
}

std::string unit_of(const FrameContext& frame) {
    return goal_unit(frame.playback.exhibit().goal, frame.kinds.goals);
}

void draw_headline(const FrameContext& frame) {
    const GoalKind* goal = frame.kinds.goals.find(frame.playback.exhibit().goal);
    caption(goal == nullptr ? "Fitness" : goal->label);
    const WithFont font(ui().fonts.title);
    const auto& result = frame.playback.exhibit().result;
    // What counted, shaking and suspicion included, if it was ever judged.
    if (result) {
        ImGui::TextUnformatted(measured(result->fitness, unit_of(frame)).c_str());
    } else if (frame.score != nullptr) {
        ImGui::TextUnformatted(measured(frame.score->score.value, unit_of(frame)).c_str());
    } else {
        ImGui::TextUnformatted("…");
    }
}

void draw_verification(const FrameContext& frame) {
    const auto& result = frame.playback.exhibit().result;
    if (!result || frame.score == nullptr || frame.score->record.samples.empty()) return;
    if (result->digest == frame.score->record.digest) {
        const WithTextColor color(colors().accent);
        ImGui::TextUnformatted("Replay verified");
        tooltip("The trial was run again and every position agrees to the last bit.");
    } else {
        const WithTextColor color(colors().danger);
        ImGui::TextUnformatted("Replay differs from its record");
        tooltip("The trial was run again and moved otherwise than when it was scored.");
    }
}

// What the same trial came to when it was computed more finely.
void draw_recomputed(const FrameContext& frame) {
    const auto& result = frame.playback.exhibit().result;
    if (!result || !result->finer) return;
    const FinerResult& finer = *result->finer;
    fact("Computed more finely", finer.outcome == Outcome::kCompleted
                                     ? measured(finer.score, unit_of(frame))
                                     : std::string(outcome_name(finer.outcome)));
    fact("Its audit", std::string(verdict_name(finer.verdict)));
}

void draw_score(const FrameContext& frame) {
    section("How it was scored");
    if (frame.score == nullptr) {
        muted_text("The trial is being run again…");
        return;
    }
    const TrialRecord& record = frame.score->record;
    if (record.outcome != Outcome::kCompleted) {
        const WithTextColor color(colors().danger);
        ImGui::TextWrapped("%s", capitalized(std::string(outcome_name(record.outcome))).c_str());
        if (!record.reason.empty()) ImGui::TextWrapped("%s", record.reason.c_str());
        return;
    }
    for (const ScoreTerm& term : frame.score->score.terms)
        fact(capitalized(term.label), measured(term.value, term.unit));
    draw_recomputed(frame);
    draw_verification(frame);
}

void draw_body(const FrameContext& frame) {
    section("Body and brain");
    const Phenotype& phenotype = frame.playback.phenotype();
    fact("Parts", std::to_string(phenotype.parts.size()));
    fact("Moving joints", std::to_string(phenotype.effector_parts.size()));
    fact("Live neurons", std::to_string(phenotype.network.order.size()));
    fact("Sensors in use", std::to_string(phenotype.sensors.size()));
    const double density = frame.playback.environment().density;
    fact("Mass", measured(phenotype.mass(density), "kg"));
    fact("Length at rest", measured(phenotype.rest_length(), "m"));
}

void draw_origin(const FrameContext& frame) {
    section("Where it comes from");
    const Exhibit& exhibit = frame.playback.exhibit();
    if (!exhibit.method.empty()) fact("Bred by", capitalized(exhibit.method));
    for (std::size_t i = 0; i < exhibit.parents.size(); ++i)
        fact(i == 0 ? "Parent" : "Second parent", exhibit.parents[i]);
    if (!exhibit.uid.empty()) fact("Identity", exhibit.uid);
    for (const MutationRecord& mutation : exhibit.mutations) {
        ImGui::Dummy({0, px(1)});
        muted_text(mutation_words(mutation, frame.kinds.mutations));
    }
}

void draw_verdict(AuditVerdict verdict) {
    const WithTextColor color(verdict == AuditVerdict::kClean ? colors().accent : colors().danger);
    ImGui::TextUnformatted(capitalized(std::string(verdict_name(verdict))).c_str());
    tooltip(
        "Clean: contacts, limits and rounding gave the creature no energy worth mentioning. "
        "Suspect: they may have. Invalid: the motion could not be computed.");
}

std::string share_text(double work, double scale) {
    return scale > 0.0 ? format("%.2g %%", 100.0 * work / scale) : measured(work, "J");
}

void draw_audit(const FrameContext& frame) {
    if (frame.score == nullptr) return;
    section("Energy audit");
    const SceneAudit& audit = frame.score->record.audit;
    draw_verdict(judge(frame.score->record));
    fact("Muscle work", measured(audit.gross_motor_work, "J"));
    fact("Lost to drag", measured(-audit.drag_work, "J"));
    fact("Lost to contact", measured(-audit.contact_work - audit.impulse_work, "J"));
    fact("Unexplained", share_text(audit.energy_residual, audit.energy_scale));
    fact("Given by contacts", share_text(audit.positive_work, audit.energy_scale));
    fact("Deepest contact", measured(1e3 * audit.max_penetration, "mm"));
    fact("Farthest past a limit", measured(audit.max_limit_overrun, "rad"));
    fact("Fastest part", measured(audit.max_part_speed, "m/s"));
    section("Work of the computer");
    fact("Evaluations", std::to_string(audit.evaluations));
    fact("Steps", std::to_string(audit.steps));
    fact("Steps tried again", std::to_string(audit.rejections));
    fact("Impacts", std::to_string(audit.events));
    fact("Fallbacks", std::to_string(audit.fallbacks));
}

}  // namespace

void CreatureTab::draw(const FrameContext& frame, Requests&) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(5)));
    draw_headline(frame);
    draw_score(frame);
    draw_body(frame);
    draw_origin(frame);
    draw_audit(frame);
    ImGui::PopStyleVar();
}

}  // namespace cambrian
