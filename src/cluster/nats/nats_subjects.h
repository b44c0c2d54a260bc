#pragma once

// The names of a cluster's streams and subjects, and the data that a subject contains.

#include "cluster/messages/work_queue.h"

#include <fmt/core.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cambrian {

class NatsSubjects {
public:
    explicit NatsSubjects(std::string cluster) : cluster_(std::move(cluster)) {}

    std::string work_stream() const { return cluster_ + "-WORK"; }
    std::string result_stream() const { return cluster_ + "-RESULT"; }
    std::string bucket() const { return cluster_ + "-settings"; }
    static constexpr const char* kConsumer = "workers";  // consumer of the stream of work

    std::string all_work() const { return cluster_ + ".work.>"; }
    std::string all_results() const { return cluster_ + ".result.>"; }
    std::string work(const UnitId& unit) const {
        return fmt::format("{}.work.{}", cluster_, unit_name(unit));
    }
    std::string result(const UnitId& unit, std::string_view login) const {
        return fmt::format("{}.result.{}.{}", cluster_, unit_name(unit), login);
    }
    std::string work_of(std::uint64_t run) const;
    std::string results_of(std::uint64_t run) const;
    std::string work_of(std::uint64_t run, std::uint32_t generation) const;
    std::string results_of(std::uint64_t run, std::uint32_t generation) const;
    // Returns the unit in a subject of work or of a result; none for other subjects.
    std::optional<UnitId> unit_of(std::string_view subject) const;
    // Returns the login in a subject of a result or of a worker's presence; empty for other
    // subjects. The server lets each login publish on subjects with its own name only.
    std::string login_of(std::string_view subject) const;

    // Subjects of presence. Workers listen to coordinators only; otherwise a thousand workers would
    // receive one another's messages.
    std::string all_hellos() const { return cluster_ + ".hello.>"; }
    std::string coordinator_hellos() const { return cluster_ + ".hello.coordinator.*"; }
    std::string coordinator_hello(std::string_view sender) const {
        return fmt::format("{}.hello.coordinator.{}", cluster_, sender);
    }
    std::string worker_hello(std::string_view login, std::string_view sender) const {
        return fmt::format("{}.hello.worker.{}.{}", cluster_, login, sender);
    }

    std::string all_stops() const { return cluster_ + ".stop.*"; }
    std::string stop(std::uint64_t run) const;
    std::optional<std::uint64_t> stopped_run(std::string_view subject) const;

    // Answers to requests arrive below these subjects; only that login of a worker, or that role,
    // may subscribe there.
    std::string worker_inbox(std::string_view login) const {
        return fmt::format("_INBOX.{}.worker.{}", cluster_, login);
    }
    std::string coordinator_inbox() const { return fmt::format("_INBOX.{}.coordinator", cluster_); }

    // Subject on which the server reports a unit that was delivered as often as its limit.
    std::string undeliverable() const {
        return fmt::format("$JS.EVENT.ADVISORY.CONSUMER.MAX_DELIVERIES.{}.{}", work_stream(),
                           kConsumer);
    }

private:
    static std::string unit_name(const UnitId& unit);

    std::string cluster_;
};

}  // namespace cambrian
