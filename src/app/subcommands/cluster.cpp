#include "app/cluster/cluster_options.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "cluster/connection/cluster_connection.h"
#include "cluster/messages/hello_text.h"
#include "core/text/counted.h"
#include "core/text/number_text.h"
#include "persist/json/json_text.h"
#include "persist/text/digest_text.h"
#include "persist/text/quoted_text.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <map>

namespace cambrian {
namespace {

constexpr std::chrono::milliseconds kListening{3000};  // each member announces itself every 2 s

// Returns the last announcement of each member: coordinators first, then by name.
std::vector<Hello> last_words(const std::vector<std::string>& texts) {
    std::map<std::uint64_t, Hello> by_id;
    for (const std::string& text : texts) {
        const Result<Hello> hello = parse_hello(text);
        if (hello) by_id.insert_or_assign(hello->id, *hello);
    }
    std::vector<Hello> all;
    for (auto& [id, hello] : by_id) {
        if (!hello.leaving) all.push_back(std::move(hello));
    }
    std::stable_sort(all.begin(), all.end(), [](const Hello& one, const Hello& other) {
        if (one.role != other.role) return one.role == Hello::Role::kCoordinator;
        return one.name < other.name;
    });
    return all;
}

std::string state_words(const Hello& hello) {
    if (!hello.refused.empty()) return "refused: " + hello.refused;
    if (hello.role == Hello::Role::kCoordinator) return "evolves";
    return hello.busy > 0 ? "working" : "idle";
}

std::string json_of(const Hello& hello) {
    return json_object({{"role", quoted_text(role_word(hello.role))},
                        {"id", quoted_text(hex_text(hello.id))},
                        {"name", quoted_text(hello.name)},
                        {"cores", std::to_string(hello.cores)},
                        {"busy", std::to_string(hello.busy)},
                        {"simulator", quoted_text(hello.simulator)},
                        {"proof", quoted_text(digest_text(hello.proof))},
                        {"units_per_second", real_text(hello.units_per_second)},
                        {"creatures_per_second", real_text(hello.creatures_per_second)},
                        {"work_per_second", real_text(hello.work_per_second)},
                        {"refused", quoted_text(hello.refused)}});
}

std::string row_of(const Hello& hello) {
    return fmt::format("{:24}  {:11}  {:<5}  {:11}  {}", hello.name, role_word(hello.role),
                       hello.cores, short_text(std::round(hello.creatures_per_second)),
                       state_words(hello));
}

std::string table_of(const std::vector<Hello>& hellos) {
    std::size_t cores = 0;
    double creatures = 0.0;
    std::string text = "name                      role         cores  creatures/s  state";
    for (const Hello& hello : hellos) {
        text += "\n" + row_of(hello);
        cores += static_cast<std::size_t>(std::max(hello.cores, 0));
        creatures += hello.creatures_per_second;
    }
    if (hellos.empty())
        return "no machine announces itself on this cluster; workers that wait for its first run "
               "are "
               "silent";
    return fmt::format("{}\n{}, {}, {} creatures/s", text, counted(hellos.size(), "machine"),
                       counted(cores, "core"), short_text(std::round(creatures)));
}

class ClusterSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        add_cluster_address(app, login_);
        app.add_flag("--json", json_, "Output as JSON, one object per line");
    }
    CommandFiles files() const override {
        CommandFiles files;
        add_login_files(files, login_);
        return files;
    }
    ExitStatus run(const EvolutionKinds& kinds) override;

private:
    ClusterLogin login_;
    bool json_ = false;
};

ExitStatus ClusterSubcommand::run(const EvolutionKinds& /*kinds*/) {
    const Result<ClusterAddress> address = cluster_address(login_);
    if (!address) return fail(address.error());
    const auto texts = listen_to_cluster(*address, kListening);
    if (!texts) return fail(texts.error());
    say_of_openness(*address);
    const std::vector<Hello> hellos = last_words(*texts);
    if (!json_) return print_result_line(table_of(hellos));
    std::string lines;
    for (const Hello& hello : hellos)
        lines += json_of(hello) + "\n";
    return print_result(lines);
}

}  // namespace

SubcommandKind cluster_subcommand() {
    return {.id = "cluster",
            .summary = "List the machines that work on a cluster and their speeds.",
            .example = "cambrian cluster nats://lab-server",
            .make = make_subcommand<ClusterSubcommand>};
}

}  // namespace cambrian
