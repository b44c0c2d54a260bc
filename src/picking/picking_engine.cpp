#include "picking/picking_engine.h"

#include <exception>
#include <string>
#include <utility>

namespace cambrian {

PickingEngine::PickingEngine(SettingsPtr settings, const EvolutionKinds& kinds,
                             std::unique_ptr<EvaluationBackend> backend)
    : backend_(std::move(backend)), session_(std::move(settings), kinds) {
    publish();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

PickingEngine::~PickingEngine() {
    thread_.request_stop();
    thread_.join();
}

void PickingEngine::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        const bool commanded =
            inbox_.drain([this](PickingCommand command) { session_.apply(std::move(command)); });
        if (commanded) publish();
        if (session_.has_work()) {
            inbox_.work_until_command(
                stop, [this](const std::stop_token& interrupted) { work(interrupted); });
        } else {
            inbox_.wait(stop);
        }
    }
}

void PickingEngine::work(const std::stop_token& interrupted) {
    try {
        if (!session_.work(*backend_, progress_, interrupted)) return;
    } catch (const std::exception& failure) {
        session_.fail(std::string("breeding failed: ") + failure.what());
    }
    publish();
}

void PickingEngine::publish() {
    snapshots_.publish(std::make_shared<const PickingSnapshot>(session_.snapshot()));
}

}  // namespace cambrian
