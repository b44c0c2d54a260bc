#include "studio/panels/inspector/creature_tab.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "genome/creature_name.h"
#include "studio/panels/inspector/sense_section.h"
#include "studio/viewer/mutation_words.h"
#include "studio/viewer/origin_words.h"
#include "studio/viewer/score_words.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

std::string unit_of(const FrameContext& frame) {
    return goal_unit(frame.viewer.playback.exhibit().settings().goal, frame.kinds.goals);
}

// Draws the range of a confirmed score in small text beside it.
void draw_range(const EvaluationResult& result) {
    const std::string range = confirmed_range(result);
    if (range.empty()) return;
    ImGui::SameLine();
    const WithFont font(ui().fonts.small);
    muted_text(range);
    tooltip(
        "Creatures that would survive are tried again in slightly different worlds; the median of "
        "all scores counts.");
}

void draw_headline(const FrameContext& frame) {
    const GoalKind* goal = frame.kinds.goals.find(frame.viewer.playback.exhibit().settings().goal);
    caption(goal == nullptr ? "Fitness" : goal->label);
    const WithFont font(ui().fonts.title);
    const EvaluationResult* result = frame.viewer.playback.exhibit().result();
    // Shows the fitness that selection used, with all penalties, if the creature completed its
    // trial.
    if (result != nullptr && result->outcome == Outcome::kCompleted) {
        ImGui::TextUnformatted(shown_score(result->fitness, unit_of(frame)).c_str());
        draw_range(*result);
    } else if (frame.viewer.score == nullptr) {
        ImGui::TextUnformatted("…");
    } else if (const Outcome outcome = frame.viewer.score->record.outcome;
               outcome == Outcome::kCompleted) {
        ImGui::TextUnformatted(
            shown_score(frame.viewer.score->score.value, unit_of(frame)).c_str());
    } else {
        ImGui::TextUnformatted(capitalized(std::string(outcome_name(outcome))).c_str());
    }
}

std::string difference(const FrameContext& frame) {
    const TickChecks& kept = frame.viewer.playback.exhibit().ticks;
    const auto tick =
        kept.empty() ? std::nullopt : first_different_tick(kept, frame.viewer.score->ticks);
    return tick ? fmt::format("Replay differs from tick {} on", *tick)
                : std::string("Replay differs from its record");
}

void draw_verification(const FrameContext& frame) {
    const EvaluationResult* result = frame.viewer.playback.exhibit().result();
    if (result == nullptr || frame.viewer.score == nullptr ||
        frame.viewer.score->record.samples.empty())
        return;
    if (result->outcome == Outcome::kStoppedEarly) {
        muted_text("Stopped early in its generation");
        tooltip("It could not survive any more. Here the whole trial is shown.");
        return;
    }
    if (result->digest == frame.viewer.score->digest) {
        const WithTextColor color(colors().accent);
        ImGui::TextUnformatted("Replay verified");
        tooltip("The trial was run again and every position agrees to the last bit.");
    } else {
        const WithTextColor color(colors().danger);
        ImGui::TextUnformatted(difference(frame).c_str());
        tooltip("The trial was run again, and the motion differs from that of the scored trial.");
    }
}

// Shows the score of the same trial when recomputed with a finer step.
void draw_recomputed(const FrameContext& frame) {
    const EvaluationResult* result = frame.viewer.playback.exhibit().result();
    if (result == nullptr || !result->finer) return;
    const FinerResult& finer = *result->finer;
    fact("Computed more finely", finer.outcome == Outcome::kCompleted
                                     ? shown_score(finer.score, unit_of(frame))
                                     : std::string(outcome_name(finer.outcome)));
    fact("Energy audit", std::string(verdict_name(finer.verdict)));
}

void draw_score(const FrameContext& frame) {
    section("Score");
    if (frame.viewer.score == nullptr) {
        muted_text("The trial is being run again…");
        return;
    }
    const TrialRecord& record = frame.viewer.score->record;
    if (record.outcome != Outcome::kCompleted) {
        const WithTextColor color(colors().danger);
        ImGui::TextWrapped("%s", capitalized(std::string(outcome_name(record.outcome))).c_str());
        if (!record.reason.empty()) ImGui::TextWrapped("%s", record.reason.c_str());
        return;
    }
    for (const ScoreTerm& term : frame.viewer.score->score.terms)
        fact(capitalized(term.label), measured(term.value, term.unit));
    draw_recomputed(frame);
    draw_verification(frame);
}

void draw_body(const FrameContext& frame) {
    section("Body and brain");
    const Phenotype& phenotype = frame.viewer.playback.creature().phenotype();
    fact("Parts", std::to_string(phenotype.parts.size()));
    fact("Moving joints", std::to_string(phenotype.effectors.size()));
    fact("Connected neurons", std::to_string(phenotype.network.order.size()));
    fact("Sensors in use", std::to_string(phenotype.sensors.size()));
    const double density = frame.viewer.playback.creature().replay().environment().density;
    fact("Mass", measured(phenotype.mass(density), "kg"));
    fact("Length at rest", measured(phenotype.rest_length(), "m"));
}

// Says of each organ where it is and what it does.
void draw_grown_organs(const FrameContext& frame) {
    const std::vector<GrownOrgan>& organs = frame.viewer.playback.creature().phenotype().organs;
    if (organs.empty()) return;
    section("Organs");
    for (const GrownOrgan& organ : organs) {
        const OrganKind& kind = frame.kinds.creature.organs[organ.kind];
        fact(kind.label, fmt::format("part {}", organ.part));
        const bool is_idle = kind.shape != nullptr && !organ.deforms;
        muted_text(is_idle
                       ? fmt::format("This part stays rigid, because the body has no room for more "
                                     "than {} deformable parts.",
                                     kMostDeformers)
                       : kind.words(std::span(organ.parameters.data(), kind.parameters.size())));
    }
}

void draw_origin(const FrameContext& frame) {
    section("Origin");
    const Individual& individual = frame.viewer.playback.exhibit().individual();
    if (!individual.method.empty())
        fact("Breeding method", method_words(individual.method, frame.kinds));
    const IndividualPtr& mother = individual.mother.get();
    if (individual.parents[0] != 0)
        fact("Parent", mother ? creature_name(*mother->genome) : uid_text(individual.parents[0]));
    if (individual.parents[1] != 0) fact("Second parent", uid_text(individual.parents[1]));
    if (individual.uid != 0) fact("Identity", uid_text(individual.uid));
    if (individual.mutations.empty()) return;
    section("Mutations");
    for (const MutationRecord& mutation : individual.mutations)
        draw_mutation(mutation, frame.kinds.mutations);
}

}  // namespace

void CreatureTab::draw(const FrameContext& frame, Requests& out) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(8), px(5)));
    draw_headline(frame);
    draw_score(frame);
    draw_body(frame);
    draw_senses(frame, out);
    draw_grown_organs(frame);
    draw_origin(frame);
    ImGui::PopStyleVar();
}

}  // namespace cambrian
