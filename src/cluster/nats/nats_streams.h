#pragma once

// The streams of a cluster on its server, with their settings.

#include "cluster/nats/nats_session.h"
#include "cluster/nats/nats_subjects.h"

#include <optional>

namespace cambrian {

// Makes those that are not there. One that is there with other settings is never changed: the
// failure shows both side by side.
std::optional<LinkFailure> make_streams(NatsSession& session, const NatsSubjects& subjects);

// Opens the bucket of settings; NATS_NOT_FOUND if nobody has made it yet.
natsStatus open_bucket(const NatsSession& session, const NatsSubjects& subjects,
                       NatsHandle<kvStore>& bucket);

// What a failed request means, in words; a refused permission is found in the session's complaints.
LinkFailure request_failure(NatsSession& session, natsStatus status, jsErrCode code,
                            const std::string& what);

}  // namespace cambrian
