#include "cluster/join_cluster.h"

#include "cluster/connection/cluster_connection.h"
#include "cluster/connection/credentials.h"
#include "cluster/coordinator/cluster_backend.h"
#include "cluster/messages/text_for_people.h"
#include "cluster/units/unit_process.h"
#include "core/hash.h"
#include "core/random_id.h"
#include "core/text/shell_word.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <array>
#include <system_error>
#include <unistd.h>

namespace cambrian {
namespace {

// Returns the identity of a run, which is the same when the run is resumed on the same machine.
std::string experiment_id(const std::filesystem::path& experiment) {
    if (experiment.empty()) return "";
    std::error_code unknown;
    Hash64 hash;
    hash.add(std::string_view(machine_name()));
    hash.add(std::string_view(std::filesystem::weakly_canonical(experiment, unknown).string()));
    return hex_text(hash.value());
}

}  // namespace

std::string machine_name() {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0 || name[0] == '\0') return "unnamed";
    return text_for_people(name.data(), kLongestName);
}

Result<std::unique_ptr<EvaluationBackend>> join_cluster(const EvolutionKinds& kinds,
                                                        const ClusterAddress& address,
                                                        const ClusterUse& use) {
    auto queue = connect_coordinator(address, experiment_id(use.experiment));
    if (!queue) return queue.error();
    ClusterOptions options;
    options.threads = use.threads;
    options.name = machine_name();
    options.server = address.servers.front();
    options.cluster = address.name;
    options.run = random_id();
    options.secret = random_id();
    options.child = run_unit_process;
    options.crash_folder = use.experiment.parent_path();
    return make_cluster_backend(kinds, *std::move(queue), std::move(options));
}

Status check_cluster(const ClusterAddress& address) {
    const auto queue = connect_coordinator(address, "");
    return queue ? Status() : Status(queue.error());
}

std::vector<std::string> openness_warnings(const ClusterAddress& address) {
    std::vector<std::string> warnings;
    const std::string& file = address.credentials;
    if (!address.encrypted && !address.on_this_machine) {
        warnings.push_back(fmt::format(
            "genomes and results travel to {} readable and unsigned; tls:// protects them",
            address.servers.front()));
        const auto credentials = file.empty() ? Result(Credentials()) : read_credentials(file);
        if (credentials && !credentials->password.empty())
            warnings.push_back(
                fmt::format("so does the password of {}; everybody on the way can use it", file));
    }
    if (!file.empty() && others_can_read(file))
        warnings.push_back(
            fmt::format("{}: other users of this machine can read it; chmod 600 {} ends this", file,
                        shell_word(file)));
    return warnings;
}

}  // namespace cambrian
