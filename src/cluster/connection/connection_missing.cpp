// Replaces the connection in a program built without libnats.
#include "cluster/connection/cluster_connection.h"

namespace cambrian {
namespace {

Error built_without() {
    return Error{
        "this program was built without libnats, by which machines work together: install "
        "libnats-dev, then configure and build again"};
}

}  // namespace

Result<std::unique_ptr<CoordinatorQueue>> connect_coordinator(const ClusterAddress& /*address*/,
                                                              std::string_view /*experiment*/) {
    return built_without();
}

Result<std::unique_ptr<WorkerQueue>> connect_worker(const ClusterAddress& /*address*/) {
    return built_without();
}

Result<std::vector<std::string>> listen_to_cluster(const ClusterAddress& /*address*/,
                                                   std::chrono::milliseconds /*time*/) {
    return built_without();
}

}  // namespace cambrian
