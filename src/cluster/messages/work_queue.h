#pragma once

// The interface of a message queue to its two users: the coordinator, which hands out units and
// collects results, and the worker, which fetches units and stores results. A queue transports
// bytes without reading them; unit_text.h, result_text.h and hello_text.h read and write them.
//
// A queue may deliver a unit several times, to several workers, late, and in any order; it may
// deliver a result several times. It does not lose an accepted unit or result, unless its server
// loses its store. The coordinator computes lost ones itself, so several calls below may fail
// without harm.
//
// Any thread may call any function at any time, unless a comment asks for a single thread.

#include "core/result.h"

#include <chrono>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// The id of a unit in a cluster. A unit of a generation is published under its number once.
// Repeated publication under the same id, after a time-out, is the same message.
struct UnitId {
    std::uint64_t run = 0;
    std::uint32_t generation = 0;  // counts calls of EvaluationBackend::evaluate
    std::uint32_t unit = 0;        // from 0 in each generation

    friend auto operator<=>(const UnitId&, const UnitId&) = default;
};

// The bytes of a message and the unit they belong to.
struct UnitMessage {
    UnitId id;
    std::string body;
    // The login of a result's worker, for which the server vouches.
    std::string login = {};
};

// An announcement (hello_text.h) and the login of the worker that made it; empty for a
// coordinator's.
struct HeardHello {
    std::string text;
    std::string login = {};
};

// The largest bodies, in bytes. A queue rejects larger ones unread and counts them as garbage.
inline constexpr std::size_t kMostUnitBytes = 4'000'000;
inline constexpr std::size_t kMostResultBytes = 4'000'000;
inline constexpr std::size_t kMostSettingsBytes = 1'000'000;
inline constexpr std::size_t kMostHelloBytes = 4'000;

// ---- The coordinator's side ----

enum class Publishing : std::uint8_t {
    // Being sent; the queue repeats it until the server stores it or gives a reason why not.
    kAccepted,
    // 256 are being sent, the stream is full or the server cannot be reached; try again later.
    kWait,
    kTooLarge,  // larger than the server's limit for a message
};

// The messages that a coordinator's queue received since the last poll().
struct CoordinatorNews {
    std::vector<UnitMessage> results;  // of the present run
    // They are of workers and of other coordinators. A worker's comes before its results.
    std::vector<HeardHello> hellos;
    // Accepted, but then rejected by the server or lost with the connection.
    std::vector<UnitId> not_published;
    // Delivered as often as the server's limit without an answer.
    std::vector<UnitId> not_deliverable;
    // Messages for users in complete sentences, each reason once: a refused permission with its
    // subject, a full stream, a lost connection.
    std::vector<std::string> complaints;
    std::uint64_t garbage = 0;  // messages with a subject or size that this program never uses

    bool empty() const {
        return results.empty() && hellos.empty() && not_published.empty() &&
               not_deliverable.empty() && complaints.empty() && garbage == 0;
    }
};

class CoordinatorQueue {
public:
    virtual ~CoordinatorQueue() = default;

    // Whether the server can be reached now. Otherwise every call returns at once and the queue
    // goes on trying to connect.
    virtual bool connected() const = 0;

    // Collects results of this run from now on, and deletes remaining units of it. Fails only while
    // not connected; the queue then does it when it is.
    virtual void begin_run(std::uint64_t run) = 0;

    // Stores settings for workers under a key of 16 hexadecimal digits. Returns false if that did
    // not succeed within a second; the caller must repeat it.
    virtual bool put_settings(std::string_view key, std::string_view text) = 0;

    // Returns as soon as the bytes are handed over.
    virtual Publishing publish(const UnitMessage& unit) = 0;

    // Returns what was received; waits up to `longest` for something. By one thread at a time.
    virtual CoordinatorNews poll(std::chrono::milliseconds longest) = 0;

    // Deletes units that are no longer needed, begun or not, as far as possible.
    virtual void withdraw(const UnitId& unit) = 0;
    virtual void withdraw_generation(std::uint64_t run, std::uint32_t generation) = 0;

    // Tells workers to drop their units of the run, and deletes its units and results.
    virtual void end_run(std::uint64_t run) = 0;

    // Sends a message to all current listeners, without storing it. `sender` has 16 hexadecimal
    // digits.
    virtual void say_hello(std::string_view sender, std::string_view text) = 0;
};

// ---- The worker's side ----

struct Delivery {
    UnitMessage unit;
    int times = 1;             // number of its deliveries, this one included
    std::uint64_t ticket = 0;  // id of this delivery, for the calls below
};

enum class SettingsState : std::uint8_t { kFound, kMissing, kAway };

struct FetchedSettings {
    SettingsState state = SettingsState::kAway;
    std::string text;  // the settings, if found
};

// The messages that a worker's queue received since the last poll().
struct WorkerNews {
    std::vector<std::string> hellos;        // of coordinators and of other workers
    std::vector<std::uint64_t> ended_runs;  // runs whose units are no longer wanted
    std::vector<std::string> complaints;    // as CoordinatorNews::complaints
};

class WorkerQueue {
public:
    virtual ~WorkerQueue() = default;

    virtual bool connected() const = 0;

    // Returns 1 to `most` units as soon as there is one. Returns none after `longest` (at most 1
    // s), or at once if the connection is lost. By one thread at a time. While not connected it
    // waits, so that a loop around it does not spin.
    virtual std::vector<Delivery> fetch(std::size_t most, std::chrono::milliseconds longest) = 0;

    // Prevents delivery to others for some time. Must be called every 2 s.
    virtual void in_progress(std::uint64_t ticket) = 0;
    // Reports that the unit is done; it is deleted.
    virtual void acknowledge(std::uint64_t ticket) = 0;
    // Returns a unit that is not done; it is delivered again after the delay, to any worker.
    virtual void give_back(std::uint64_t ticket, std::chrono::milliseconds delay) = 0;
    // Reports that the unit cannot be read by anyone; it is never delivered again.
    virtual void discard(std::uint64_t ticket) = 0;

    // Returns true when the result is stored, and false after a second without an answer. The call
    // may be repeated, since the server drops duplicates.
    virtual bool publish_result(const UnitMessage& result) = 0;

    virtual FetchedSettings fetch_settings(std::string_view key) = 0;

    virtual WorkerNews poll() = 0;  // does not wait
    virtual void say_hello(std::string_view sender, std::string_view text) = 0;
};

}  // namespace cambrian
