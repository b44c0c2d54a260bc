#pragma once

// Owners of libnats's objects.

#include <memory>
#include <nats/nats.h>

namespace cambrian {

struct NatsFree {
    void operator()(natsOptions* options) const { natsOptions_Destroy(options); }
    void operator()(natsConnection* connection) const { natsConnection_Destroy(connection); }
    void operator()(jsCtx* context) const { jsCtx_Destroy(context); }
    void operator()(natsSubscription* subscription) const {
        natsSubscription_Destroy(subscription);
    }
    void operator()(natsMsg* message) const { natsMsg_Destroy(message); }
    void operator()(jsStreamInfo* info) const { jsStreamInfo_Destroy(info); }
    void operator()(jsConsumerInfo* info) const { jsConsumerInfo_Destroy(info); }
    void operator()(jsMsgMetaData* facts) const { jsMsgMetaData_Destroy(facts); }
    void operator()(jsPubAck* acknowledgement) const { jsPubAck_Destroy(acknowledgement); }
    void operator()(kvStore* bucket) const { kvStore_Destroy(bucket); }
    void operator()(kvEntry* entry) const { kvEntry_Destroy(entry); }
};

template <class Object>
using NatsHandle = std::unique_ptr<Object, NatsFree>;

}  // namespace cambrian
