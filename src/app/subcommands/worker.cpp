#include "cluster/worker/worker.h"

#include "app/cluster/cluster_options.h"
#include "app/command_line/number_checks.h"
#include "app/command_line/priority_option.h"
#include "app/process/interruption.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "cluster/connection/cluster_connection.h"
#include "cluster/join_cluster.h"
#include "cluster/messages/text_for_people.h"
#include "cluster/units/unit_child.h"
#include "core/random_id.h"
#include "core/threads/thread_pool.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>

namespace cambrian {
namespace {

class WorkerSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        add_cluster_address(app, login_);
        take_whole(
            *app.add_option("-t,--threads", threads_, "Number of cores to use; all by default"), 1,
            1024);
        add_priority(app, priority_);
        app.add_option("--name", name_, "Name of this machine in tables; its host name by default")
            ->type_name("TEXT");
        app.add_flag("--unit", unit_,
                     "Single unit of work, read from standard input, instead of a cluster's; "
                     "`cambrian evolve` computes units in this way that may have crashed a worker");
    }
    CommandFiles files() const override {
        CommandFiles files;
        add_login_files(files, login_);
        return files;
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        return unit_ ? compute_unit(kinds) : work(kinds);
    }

private:
    static ExitStatus compute_unit(const EvolutionKinds& kinds);
    ExitStatus work(const EvolutionKinds& kinds);

    ClusterLogin login_;
    std::optional<std::size_t> threads_;
    ThreadPriority priority_ = ThreadPriority::kBackground;
    std::string name_;
    bool unit_ = false;
};

ExitStatus WorkerSubcommand::compute_unit(const EvolutionKinds& kinds) {
    const std::string question{std::istreambuf_iterator<char>(std::cin), {}};
    const Result<std::string> answer = answer_question(question, kinds);
    if (!answer) return fail(answer.error());
    return print_result(*answer);
}

ExitStatus WorkerSubcommand::work(const EvolutionKinds& kinds) {
    const Result<ClusterAddress> address = cluster_address(login_);
    if (!address) return fail(address.error());
    const auto queue = connect_worker(*address);
    if (!queue) return fail(queue.error());
    say_of_openness(*address);
    const Interruption interruption;
    WorkerOptions options;
    options.id = random_id();
    options.threads = {.workers = threads_.value_or(ThreadPool::default_workers()),
                       .priority = priority_};
    options.name = name_.empty() ? machine_name() : text_for_people(name_, kLongestName);
    options.say = [](std::string_view words) { say(words); };
    work_for_cluster(kinds, **queue, options, interruption.token());
    return ExitStatus::kDone;
}

}  // namespace

SubcommandKind worker_subcommand() {
    return {.id = "worker",
            .summary = "Lend this machine's cores to runs on other machines, until Ctrl+C.",
            .example = "cambrian worker nats://lab-server",
            .make = make_subcommand<WorkerSubcommand>};
}

}  // namespace cambrian
