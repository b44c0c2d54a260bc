#pragma once

// Owns the evaluation back-end: this machine's cores, alone or with a cluster.

#include "studio/background/services.h"
#include "studio/experiment/experiment_controller.h"
#include "studio/machines/cluster_memory.h"
#include "studio/machines/machine_options.h"
#include "studio/machines/machines_contract.h"

#include <memory>

namespace cambrian {

class MachinesController {
public:
    // The references in `services` must outlive the controller; `experiment` need not exist before
    // begin().
    MachinesController(const Services& services, ExperimentController& experiment,
                       MachineOptions options);

    // The back-end that an experiment starts with.
    const std::shared_ptr<EvaluationBackend>& own_cores() const { return own_; }

    // Joins the cluster that the options name. Without one, joins the stored cluster if the program
    // was joined to it when it ended.
    void begin(const ClusterMemory& remembered);
    // Must be called once a frame; `now` is in seconds of the window's clock.
    void update(double now);
    void carry_out(const MachinesRequest& request);
    const MachinesView& facts() const { return facts_; }
    ClusterMemory memory() const;

private:
    struct Handler;
    struct Attempt;
    static Attempt attempt_to_join(const ClusterLogin& login, const ThreadShare& threads,
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
    std::shared_ptr<EvaluationBackend> used_;  // the back-end in use; never null
    MachinesView facts_;
    unsigned attempts_ = 0;
    double read_at_ = -1.0;  // s; time of the last reading of the status
};

}  // namespace cambrian
