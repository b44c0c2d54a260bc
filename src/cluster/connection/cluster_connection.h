#pragma once

// The way to a cluster's server. A program built without libnats fails each call and says what to
// install.

#include "cluster/connection/cluster_address.h"
#include "cluster/messages/work_queue.h"
#include "core/result.h"

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// All fail, in one sentence, for errors that waiting does not cure: no such host, no NATS server,
// no JetStream, wrong credentials, a certificate that is not trusted, streams with other settings.

// A server that cannot be reached is no failure: the queue connects as soon as it can and complains
// meanwhile. experiment: 16 hexadecimal digits, the same for a run that is resumed, so that what is
// left of it is deleted; empty for none.
Result<std::unique_ptr<CoordinatorQueue>> connect_coordinator(const ClusterAddress& address,
                                                              std::string_view experiment);
Result<std::unique_ptr<WorkerQueue>> connect_worker(const ClusterAddress& address);

// What workers and coordinators say of themselves within the time (hello_text.h). Fails also if the
// server cannot be reached.
Result<std::vector<std::string>> listen_to_cluster(const ClusterAddress& address,
                                                   std::chrono::milliseconds time);

}  // namespace cambrian
