#include "studio/files/clip_maker.h"

#include "persist/creature/creature_card.h"
#include "pictures/workshop.h"

#include <algorithm>
#include <utility>

namespace cambrian {

Status write_trial_clip(TrialClip& clip, const EvolutionKinds& kinds, const TrialWatch& watch) {
    complete_score(clip.document, kinds, watch.stop);
    auto subject =
        subject_of(clip.document, clip.settings, clip.title, kinds, {.stop = watch.stop});
    if (!subject) return subject.error();
    subject->generation = clip.generation;
    const ClipChoice& choice = clip.choice;
    const auto workshop = open_workshop(choice.width, choice.height);
    if (!workshop) return workshop.error();
    const ClipOrder order{
        .format = choice.format,
        .path = clip.path,
        .timing = {.frames_a_second = choice.format->usual_rate,
                   .speed = choice.speed,
                   .seconds = std::min(choice.seconds, subject->motion().length())},
        .palette = clip.palette,
        .card = choice.card,
        .creature = write_creature(clip.document, kinds)};
    return write_clip(*(*workshop)->canvas, *subject, kinds.creature, order, watch);
}

const std::vector<ClipKind>& clip_kinds() {
    static const std::vector<ClipKind> kinds = [] {
        std::vector<ClipKind> offered;
        for (const ClipFormat& format : clip_formats()) {
            if (format.embeds) {
                offered.push_back({"Moving card", kCardEnding, &format, true});
            } else {
                offered.push_back({std::string(format.label), format.ending, &format, false});
            }
        }
        return offered;
    }();
    return kinds;
}

const ClipKind* clip_kind_of(std::string_view name) {
    const std::vector<ClipKind>& kinds = clip_kinds();
    const auto kind = std::find_if(kinds.begin(), kinds.end(), [name](const ClipKind& each) {
        return name.ends_with(each.ending);
    });
    return kind == kinds.end() ? nullptr : &*kind;
}

}  // namespace cambrian
