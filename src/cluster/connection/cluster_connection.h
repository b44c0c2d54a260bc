#pragma once

// Connections to a cluster's server. In a program built without libnats, every call fails and says
// what to install.

#include "cluster/connection/cluster_address.h"
#include "cluster/messages/work_queue.h"
#include "core/result.h"

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// All functions fail, in one sentence, for errors that are permanent: unknown host, no NATS server,
// no JetStream, wrong credentials, an untrusted certificate, streams with other settings.

// A server that cannot be reached is not an error: the queue connects as soon as possible and
// reports complaints meanwhile. `experiment` has 16 hexadecimal digits and is the same for a
// resumed run, so that its old messages are deleted; it is empty for none.
Result<std::unique_ptr<CoordinatorQueue>> connect_coordinator(const ClusterAddress& address,
                                                              std::string_view experiment);
Result<std::unique_ptr<WorkerQueue>> connect_worker(const ClusterAddress& address);

// Returns the hellos of workers and coordinators during that time (hello_text.h). Also fails if the
// server cannot be reached.
Result<std::vector<std::string>> listen_to_cluster(const ClusterAddress& address,
                                                   std::chrono::milliseconds time);

}  // namespace cambrian
