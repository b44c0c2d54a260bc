#include "studio/viewer/drawing_edits.h"

#include "math/angle.h"
#include "sketch/part_edits.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {
namespace {

std::string gene_words(const BodySketch& sketch, std::size_t part) {
    return fmt::format("part {}", sketch.body.parts[part].node);
}

Result<std::size_t> chosen_part(const DrawnBody& body) {
    if (body.drawing.chosen) {
        if (const auto part = find_part(body.sketch, *body.drawing.chosen)) return *part;
    }
    return Error{"click a part first"};
}

Result<std::size_t> chosen_limb(const DrawnBody& body) {
    Result<std::size_t> part = chosen_part(body);
    if (part && *part == 0) return Error{"this is the first part, from which the others grow"};
    return part;
}

DrawnEdit edit_of(Genome genome, std::string place, std::string from, std::string to) {
    return {std::move(genome), {std::move(place), std::move(from), std::move(to)}};
}

std::string rhythm_words(const Rhythm& rhythm) {
    return fmt::format("{:.2f} Hz, {:.0f}°, wave {:.2f}", rhythm.frequency,
                       to_degrees(rhythm.swing), rhythm.wave);
}

}  // namespace

Result<DrawnEdit> without_chosen(const DrawnBody& body) {
    const Result<std::size_t> part = chosen_limb(body);
    if (!part) return part.error();
    return edit_of(remove_part(body.sketch, *part, body.rules), gene_words(body.sketch, *part),
                   fmt::format("{:.2f} m", body.sketch.body.parts[*part].length), "removed");
}

Result<DrawnEdit> with_repeats(const DrawnBody& body, int times) {
    const Result<std::size_t> part = chosen_part(body);
    if (!part) return part.error();
    Result<Genome> repeated = repeat_part(body.sketch, *part, times, body.rules);
    if (!repeated) return repeated.error();
    return edit_of(*std::move(repeated), gene_words(body.sketch, *part) + " repeats",
                   std::to_string(repeats_of(body.sketch, *part)), std::to_string(times));
}

Result<DrawnEdit> with_pair_switched(const DrawnBody& body) {
    const Result<std::size_t> part = chosen_limb(body);
    if (!part) return part.error();
    const MirrorSides wanted = body.drawing.mirror;
    Result<Genome> switched =
        switch_pair(body.sketch, *part,
                    wanted == MirrorSides::kNone ? MirrorSides::kSideways : wanted, body.rules);
    if (!switched) return switched.error();
    const bool was = is_paired(body.sketch, *part);
    return edit_of(*std::move(switched), gene_words(body.sketch, *part) + " on both sides",
                   was ? "yes" : "no", was ? "no" : "yes");
}

Result<DrawnEdit> with_given_rhythm(const DrawnBody& body, const Rhythm& rhythm) {
    Result<Genome> moving = with_rhythm(body.sketch, rhythm, body.rules);
    if (!moving) return moving.error();
    const std::optional<Rhythm> before = rhythm_of(body.sketch, body.rules);
    DrawnEdit edit = edit_of(*std::move(moving), "rhythm", before ? rhythm_words(*before) : "",
                             rhythm_words(rhythm));
    edit.is_complete = false;
    return edit;
}

}  // namespace cambrian
