#include "studio/viewer/sense_study.h"

#include <utility>

namespace cambrian {

void SenseStudy::begin(const Exhibit& exhibit) {
    clear();
    running_ = std::make_shared<Running>();
    worker_.submit(
        [this, running = running_, genome = exhibit.genome(), settings = exhibit.creature.settings](
            const std::stop_token& stop) -> BackgroundWorker::Completion {
            const std::stop_callback forward(stop, [&running] { running->stop.request_stop(); });
            SenseLosses losses = sense_losses(genome, *settings, kinds_, running->stop.get_token(),
                                              [&running](double share) { running->share = share; });
            return [this, running, losses = std::move(losses)] {
                if (running != running_) return;
                running_.reset();
                losses_ = losses;
            };
        });
}

void SenseStudy::clear() {
    if (running_) running_->stop.request_stop();
    running_.reset();
    losses_.reset();
}

}  // namespace cambrian
