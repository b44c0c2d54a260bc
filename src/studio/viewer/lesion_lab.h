#pragma once

// The lesion lab of the window: studies the displayed creature, or prunes it, in the background.

#include "evolution/evaluation/lesion_table.h"
#include "evolution/evaluation/pruning.h"
#include "studio/background/background_worker.h"
#include "studio/playback/exhibit.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace cambrian {

class LesionLab {
public:
    // `kinds` must outlive the object.
    explicit LesionLab(const EvolutionKinds& kinds) : kinds_(kinds) {}
    LesionLab(const LesionLab&) = delete;
    LesionLab& operator=(const LesionLab&) = delete;
    ~LesionLab() { stop(); }

    // Each gives up what runs and begins anew.
    void study(const Exhibit& exhibit, bool pairs);
    void prune(const Exhibit& exhibit);
    void stop();
    // Must be called once a frame. Returns the genome that was pruned and its pruned twin, once.
    struct Pruning {
        GenomePtr whole;
        PrunedCreature twin;
    };
    std::optional<Pruning> update();

    bool running() const { return task_ != nullptr; }
    bool pruning() const { return running() && task_->prunes; }
    double share() const;  // of the present study that is done, 0 to 1
    // The lesions of a creature, or null if they were not studied last.
    const LesionTable* table_of(const GenomePtr& genome) const {
        return genome == studied_ && table_ ? &*table_ : nullptr;
    }

private:
    struct Task {
        bool prunes = false;
        bool pairs = false;
        EvaluationProgress progress;
        std::stop_source stop;
    };
    void begin(const Exhibit& exhibit, const std::shared_ptr<Task>& task);
    BackgroundWorker::Completion work(const std::shared_ptr<Task>& task,
                                      const JudgedIndividual& one, const std::stop_token& stop);

    const EvolutionKinds& kinds_;
    std::shared_ptr<Task> task_;
    GenomePtr studied_;
    std::optional<LesionTable> table_;
    std::optional<Pruning> pruning_;
    BackgroundWorker worker_;  // last member, so that it ends before the others
};

}  // namespace cambrian
