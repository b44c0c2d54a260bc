#pragma once

// Owns what evolution evaluates with: this machine's cores alone, or a cluster and them.

#include "studio/background/services.h"
#include "studio/experiment/experiment_controller.h"
#include "studio/machines/cluster_memory.h"
#include "studio/machines/machine_options.h"
#include "studio/machines/machines_contract.h"

#include <memory>

namespace cambrian {

class MachinesController {
public:
    // Everything that `services` names must outlive it; `experiment` need not exist before begin().
    MachinesController(const Services& services, ExperimentController& experiment,
                       MachineOptions options);

    // What an experiment evaluates with at first.
    const std::shared_ptr<EvaluationBackend>& own_cores() const { return own_; }

    // Joins the cluster that the options name or, without one, the remembered one if it was joined
    // when the program ended.
    void begin(const ClusterMemory& remembered);
    // Once a frame: `now` is in seconds of the window's clock.
    void update(double now);
    void carry_out(const MachinesRequest& request);
    const MachinesView& facts() const { return facts_; }
    ClusterMemory memory() const;

private:
    struct Handler;
    struct Attempt;
    static Attempt attempt_to_join(const ClusterLogin& login, std::size_t workers,
                                   const ClusterJoining& join);
    void join(const ClusterLogin& login);
    void leave();
    void finish(const Attempt& attempt);
    void use(std::shared_ptr<EvaluationBackend> backend);
    void tell_changes(const BackendStatus& before);

    Services services_;
    ExperimentController& experiment_;
    MachineOptions options_;
    const std::shared_ptr<EvaluationBackend> own_;
    std::shared_ptr<EvaluationBackend> used_;  // never null
    MachinesView facts_;
    unsigned attempts_ = 0;
    double read_at_ = -1.0;  // s; when the status was read last
};

}  // namespace cambrian
