#pragma once

// The streams of a cluster on its server, with their settings.

#include "cluster/nats/nats_session.h"
#include "cluster/nats/nats_subjects.h"

#include <optional>

namespace cambrian {

// Makes the streams that do not exist. An existing stream with other settings is never changed; the
// failure shows both settings.
std::optional<LinkFailure> make_streams(NatsSession& session, const NatsSubjects& subjects);

// Opens the bucket of settings; NATS_NOT_FOUND if it does not exist yet.
natsStatus open_bucket(const NatsSession& session, const NatsSubjects& subjects,
                       NatsHandle<kvStore>& bucket);

// Returns the meaning of a failed request. If it was refused, the session's refusal
// tells why, and is taken from it.
LinkFailure request_failure(NatsSession& session, natsStatus status, jsErrCode code,
                            const std::string& what);

}  // namespace cambrian
