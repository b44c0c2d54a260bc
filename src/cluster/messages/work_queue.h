#pragma once

// What the cluster asks of a message queue, as its two users see it: the coordinator, which hands
// out units and collects results, and the worker, which fetches units and stores results. A queue
// carries bytes and does not look into them; unit_text.h, result_text.h and hello_text.h read and
// write them.
//
// A queue may deliver a unit several times, to several workers, late, and in any order; it may
// deliver a result several times. It does not lose a unit or a result that was accepted, unless its
// server loses its store. What it does lose, the coordinator computes itself (several calls below
// may therefore fail without harm).
//
// Any thread may call any function at any time, except where one thread is asked for.

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

// Names a unit among all of a cluster. A unit of a generation is published under its number once;
// what is published again after a time-out under the same id is the same message.
struct UnitId {
    std::uint64_t run = 0;
    std::uint32_t generation = 0;  // counts calls of EvaluationBackend::evaluate
    std::uint32_t unit = 0;        // from 0 in each generation

    friend auto operator<=>(const UnitId&, const UnitId&) = default;
};

// The bytes of a message and which unit they belong to.
struct UnitMessage {
    UnitId id;
    std::string body;
};

// The largest bodies, in bytes. A queue refuses larger ones unread, and counts them as garbage.
inline constexpr std::size_t kMostUnitBytes = 4'000'000;
inline constexpr std::size_t kMostResultBytes = 4'000'000;
inline constexpr std::size_t kMostSettingsBytes = 1'000'000;
inline constexpr std::size_t kMostHelloBytes = 4'000;

// ---- The coordinator's side ----

enum class Publishing : std::uint8_t {
    kAccepted,  // on its way; the queue repeats it until the server has it or says why not
    kWait,      // 256 are on their way, the stream is full or the server is away; try again later
    kTooLarge,  // more than the server takes in one message; make it smaller
};

// What a coordinator's queue has heard since it was last asked.
struct CoordinatorNews {
    std::vector<UnitMessage> results;     // of the present run
    std::vector<std::string> hellos;      // of workers and of other coordinators
    std::vector<UnitId> not_published;    // accepted, but the server refused them or went away
    std::vector<UnitId> not_deliverable;  // delivered as often as the server does, never answered
    // Messages for people, complete sentences, each reason once: a refused permission with its
    // subject, a stream that is full, a lost connection.
    std::vector<std::string> complaints;
    std::uint64_t garbage = 0;  // messages with a subject or size that no one of ours has

    bool empty() const {
        return results.empty() && hellos.empty() && not_published.empty() &&
               not_deliverable.empty() && complaints.empty() && garbage == 0;
    }
};

class CoordinatorQueue {
public:
    virtual ~CoordinatorQueue() = default;

    // Whether the server can be reached at this moment. While it cannot, every call returns at once
    // and the queue goes on trying to connect.
    virtual bool connected() const = 0;

    // Results of this run are collected from now on; what may be left of its units is deleted.
    // Fails only while not connected; the queue then does it as soon as it is.
    virtual void begin_run(std::uint64_t run) = 0;

    // Stored for workers under a key of 16 hexadecimal digits. False if that did not succeed within
    // a second; to be tried again.
    virtual bool put_settings(std::string_view key, std::string_view text) = 0;

    // Never blocks for longer than it takes to hand the bytes over.
    virtual Publishing publish(const UnitMessage& unit) = 0;

    // What was heard; waits up to `longest` for something. By one thread at a time.
    virtual CoordinatorNews poll(std::chrono::milliseconds longest) = 0;

    // Deletes units nobody needs any more, begun or not, as far as that is possible.
    virtual void withdraw(const UnitId& unit) = 0;
    virtual void withdraw_generation(std::uint64_t run, std::uint32_t generation) = 0;

    // Tells workers to drop what they have of the run, and deletes its units and results.
    virtual void end_run(std::uint64_t run) = 0;

    // Not stored; who listens hears it. `sender`: 16 hexadecimal digits.
    virtual void say_hello(std::string_view sender, std::string_view text) = 0;
};

// ---- The worker's side ----

struct Delivery {
    UnitMessage unit;
    int times = 1;             // that it has been delivered, this one with it
    std::uint64_t ticket = 0;  // of this delivery, for the calls below
};

enum class SettingsState : std::uint8_t { kFound, kMissing, kAway };

struct FetchedSettings {
    SettingsState state = SettingsState::kAway;
    std::string text;  // if found
};

// What a worker's queue has heard since it was last asked.
struct WorkerNews {
    std::vector<std::string> hellos;        // of coordinators and of other workers
    std::vector<std::uint64_t> ended_runs;  // whose units are not wanted any more
    std::vector<std::string> complaints;    // as CoordinatorNews::complaints
};

class WorkerQueue {
public:
    virtual ~WorkerQueue() = default;

    virtual bool connected() const = 0;

    // 1 to `most` units, as soon as there is one; none after `longest` (at most 1 s), or at once if
    // the connection is lost meanwhile. By one thread at a time. While not connected it waits, so
    // that a loop around it does not spin.
    virtual std::vector<Delivery> fetch(std::size_t most, std::chrono::milliseconds longest) = 0;

    // Not to be delivered to anyone else for a while yet. To be called every 2 s.
    virtual void in_progress(std::uint64_t ticket) = 0;
    // Done: deleted.
    virtual void acknowledge(std::uint64_t ticket) = 0;
    // Not done: to be delivered again after the delay, to any worker.
    virtual void give_back(std::uint64_t ticket, std::chrono::milliseconds delay) = 0;
    // Never to be delivered again: nobody can read it.
    virtual void discard(std::uint64_t ticket) = 0;

    // True once the result is stored. False after a second without an answer; to be repeated, the
    // server drops what it stored already.
    virtual bool publish_result(const UnitMessage& result) = 0;

    virtual FetchedSettings fetch_settings(std::string_view key) = 0;

    virtual WorkerNews poll() = 0;  // without waiting
    virtual void say_hello(std::string_view sender, std::string_view text) = 0;
};

}  // namespace cambrian
