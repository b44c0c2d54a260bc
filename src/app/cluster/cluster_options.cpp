#include "app/cluster/cluster_options.h"

#include "app/command_line/option_types.h"
#include "app/process/messages.h"
#include "cluster/join_cluster.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

constexpr const char* kAddress =
    "Address of the cluster's NATS server, nats://HOST or tls://HOST; commas separate several "
    "servers of the same cluster";
constexpr const char* kAddressType = "URL";

std::vector<CLI::Option*> add_login(CLI::App& app, ClusterLogin& login) {
    return {
        app.add_option("--credentials", login.credentials,
                       "File with user and password for the server, or a NATS credentials file "
                       "(*.creds); no "
                       "login by default")
            ->type_name(option_type::kFile),
        app.add_option(
               "--ca", login.authority,
               "Certificates (PEM) of the authorities that tls:// trusts; the system's by default")
            ->type_name(option_type::kFile),
        app.add_option("--cluster-name", login.name,
                       "Name of the cluster; several clusters may share a server")
            ->type_name("NAME")
            ->default_str(kStandardClusterName)};
}

}  // namespace

void add_cluster_address(CLI::App& app, ClusterLogin& login) {
    app.add_option("server", login.servers, kAddress)->type_name(kAddressType);
    add_login(app, login);
}

void add_cluster_choice(CLI::App& app, ClusterLogin& login) {
    auto* cluster =
        app.add_option("--cluster", login.servers,
                       std::string(kAddress) + "; only this machine evaluates by default")
            ->type_name(kAddressType);
    for (CLI::Option* option : add_login(app, login))
        option->needs(cluster);
}

void add_login_files(CommandFiles& files, const ClusterLogin& login) {
    files.reads(login.credentials).reads(login.authority);
}

void say_of_openness(const ClusterAddress& address) {
    for (const std::string& warning : openness_warnings(address))
        say(warning);
}

Result<ClusterAddress> usable_cluster(const ClusterLogin& login) {
    Result<ClusterAddress> address = cluster_address(login);
    if (!address) return address;
    if (const Status usable = check_cluster(*address); !usable) return usable.error();
    say_of_openness(*address);
    return address;
}

}  // namespace cambrian
