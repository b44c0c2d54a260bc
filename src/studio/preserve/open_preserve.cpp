#include "studio/preserve/open_preserve.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLogInterval = 0.5;  // s between two states in the log

}  // namespace

OpenPreserve::OpenPreserve(OpenedWorld opened, const ThreadShare& threads)
    : settings_(opened.start.preserve->settings()),
      file_(std::move(opened.file)),
      engine_(std::move(opened.start), threads),
      picture_(engine_.latest()) {}

void OpenPreserve::update(Feedback& feedback) {
    const auto before = std::exchange(picture_, engine_.latest());
    if (before == picture_) return;
    if (before->failure != picture_->failure && !picture_->failure.empty()) {
        const char* advice = picture_->broken ? ". Open it again to go on from its last snapshot."
                                              : ". Press Play to try again.";
        feedback.tell(NoticeKind::kProblem,
                      "The preserve is paused: " + picture_->failure + advice);
    }
    follow_picked(feedback);
    tell_news(feedback);
    log_state(feedback);
}

void OpenPreserve::pick(std::uint64_t number) {
    const ResidentPicture* found = picture_->find(number);
    if (found != nullptr) {
        picked_ = *found;
    } else {
        picked_.reset();
    }
    send(WatchBrain{picked_ ? number : 0});
}

void OpenPreserve::follow_picked(Feedback& feedback) {
    if (!picked_ || picked_->life.died != 0) return;
    const std::uint64_t number = picked_->life.number;
    if (const ResidentPicture* found = picture_->find(number)) {
        picked_ = *found;
        return;
    }
    const auto& died = *picture_->died;
    const auto dead = std::find_if(died.rbegin(), died.rend(),
                                   [&](const Life& life) { return life.number == number; });
    if (dead == died.rend()) return;
    picked_->life = *dead;
    picked_->store = 0.0;
    picked_->body = 0.0;
    picked_->bitten = false;
    feedback.log().write(
        "died", {{"number", static_cast<double>(number)},
                 {"cause", std::string(kDeathCauses[static_cast<std::size_t>(dead->cause)])}});
}

void OpenPreserve::tell_news(Feedback& feedback) {
    for (const PreserveNews& news : picture_->news) {
        if (news.id <= told_) continue;
        told_ = news.id;
        feedback.log().write("intervention", {{"what", news.what},
                                              {"number", static_cast<double>(news.number)},
                                              {"done", news.problem.empty()}});
        if (!news.problem.empty()) feedback.tell(NoticeKind::kProblem, news.problem);
        if (news.what == intervention::kAdd && news.problem.empty()) pick(news.number);
    }
}

// Lets tests follow the world.
void OpenPreserve::log_state(Feedback& feedback) {
    if (picture_->playing && feedback.now() - logged_ < kLogInterval) return;
    logged_ = feedback.now();
    const auto real = [](auto number) { return static_cast<double>(number); };
    feedback.log().write("world", {{"tick", real(picture_->tick)},
                                   {"creatures", real(picture_->residents.size())},
                                   {"plants", real(picture_->plants.size())},
                                   {"walls", real(picture_->walls.size())},
                                   {"playing", picture_->playing},
                                   {"pace", picture_->pace},
                                   {"factor", picture_->factor},
                                   {"picked", picked_ ? real(picked_->life.number) : 0.0},
                                   {"x", picked_ ? picked_->center.x() : 0.0},
                                   {"y", picked_ ? picked_->center.y() : 0.0}});
}

}  // namespace cambrian
