#include "studio/files/clip_maker.h"

#include "persist/creature/creature_card.h"
#include "pictures/workshop.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

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

}  // namespace

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

void ClipMaker::submit(const std::filesystem::path& path, double length,
                       std::function<Status(const TrialWatch&)> work) {
    auto making = std::make_shared<Making>();
    making->path = path;
    making->length = length;
    making_.push_back(making);
    worker_.submit([this, making, work = std::move(work)](
                       const std::stop_token& stop) -> BackgroundWorker::Completion {
        const std::stop_callback forward(stop, [&making] { making->stop.request_stop(); });
        const std::stop_token asked = making->stop.get_token();
        Status status = asked.stop_requested() ? Error{"interrupted; nothing was written"}
                                               : work({.stop = asked, .time = &making->time});
        return [this, making, status = std::move(status)] {
            std::erase(making_, making);
            finished_.push_back({making->path, status, making->stop.stop_requested()});
        };
    });
}

void ClipMaker::make(TrialClip clip) {
    const std::filesystem::path path = clip.path;
    const double seconds = clip.choice.seconds;
    submit(path, seconds,
           [clip = std::make_shared<TrialClip>(std::move(clip)), &kinds = kinds_](
               const TrialWatch& watch) { return write_trial_clip(*clip, kinds, watch); });
}

void ClipMaker::make(const std::filesystem::path& path, const ClipFormat& format, SeenClip seen) {
    const double length = seen.end - seen.pictures.front().time;
    submit(path, length, [path, &format, seen = std::move(seen)](const TrialWatch& watch) {
        return write_seen_clip(seen, format, path, watch);
    });
}

void ClipMaker::stop() {
    if (!making_.empty()) making_.front()->stop.request_stop();
}

ClipProgress ClipMaker::progress() const {
    if (making_.empty()) return {};
    const Making& making = *making_.front();
    const double share = making.length > 0.0 ? making.time / making.length : 0.0;
    return {making.path.filename().string(), std::clamp(share, 0.0, 1.0),
            making.stop.stop_requested()};
}

std::vector<FinishedClip> ClipMaker::take_finished() {
    worker_.deliver();
    return std::exchange(finished_, {});
}

}  // namespace cambrian
