// The program with a fault in its workers, which the environment variable CAMBRIAN_FAULT names:
//   flips   one bit of the first result of each batch is false
//   slow    each unit takes 20 times as long
//   silent  units are computed and never answered
//   refuses a process of its own ends with a message instead of computing a unit
//   dies    a genome ends every process that evaluates it. Its hash is in the file `poison` of the
//           folder it runs in; the first worker that gets a unit writes there the unit's first.
// Everything else is as in the program itself: `worker URL --name NAME`, with one thread, and all
// other subcommands.

#include "app/command_line.h"
#include "app/process/messages.h"
#include "app/process/process.h"
#include "cluster/bit_flipper.h"
#include "cluster/connection/cluster_connection.h"
#include "cluster/messages/result_text.h"
#include "cluster/messages/unit_text.h"
#include "cluster/units/unit_child.h"
#include "cluster/worker/worker.h"
#include "core/files/file_io.h"
#include "core/random_id.h"
#include "persist/text/digest_text.h"
#include "support/kinds.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>

using namespace cambrian;
using namespace cambrian::test;
using std::chrono::milliseconds;

namespace {

// A queue without faults. Each fault overrides some of its functions.
class SoundQueue : public WorkerQueue {
public:
    explicit SoundQueue(std::unique_ptr<WorkerQueue> inner) : inner_(std::move(inner)) {}

    bool connected() const override { return inner_->connected(); }
    std::vector<Delivery> fetch(std::size_t most, milliseconds longest) override {
        return inner_->fetch(most, longest);
    }
    void in_progress(std::uint64_t ticket) override { inner_->in_progress(ticket); }
    void acknowledge(std::uint64_t ticket) override { inner_->acknowledge(ticket); }
    void give_back(std::uint64_t ticket, milliseconds delay) override {
        inner_->give_back(ticket, delay);
    }
    void discard(std::uint64_t ticket) override { inner_->discard(ticket); }
    bool publish_result(const UnitMessage& result) override {
        return inner_->publish_result(result);
    }
    FetchedSettings fetch_settings(std::string_view key) override {
        return inner_->fetch_settings(key);
    }
    WorkerNews poll() override { return inner_->poll(); }
    void say_hello(std::string_view sender, std::string_view text) override {
        inner_->say_hello(sender, text);
    }

private:
    std::unique_ptr<WorkerQueue> inner_;
};

class FlippingQueue final : public SoundQueue {
public:
    using SoundQueue::SoundQueue;
    bool publish_result(const UnitMessage& result) override {
        UnitMessage message = result;
        flipper_.change(message);
        return SoundQueue::publish_result(message);
    }

private:
    BitFlipper flipper_;
};

constexpr double kSlowness = 20.0;  // times as slow

class SlowQueue final : public SoundQueue {
public:
    using SoundQueue::SoundQueue;
    bool publish_result(const UnitMessage& result) override {
        const double seconds = parse_unit_result(result.body)->seconds;
        std::this_thread::sleep_for(std::chrono::duration<double>((kSlowness - 1.0) * seconds));
        return SoundQueue::publish_result(result);
    }
};

class SilentQueue final : public SoundQueue {
public:
    using SoundQueue::SoundQueue;
    void in_progress(std::uint64_t /*ticket*/) override {}
    void acknowledge(std::uint64_t /*ticket*/) override {}
    bool publish_result(const UnitMessage& /*result*/) override { return true; }
};

constexpr const char* kPoisonFile = "poison";

std::string poison() {
    const Result<std::string> text = read_file(kPoisonFile, 100);
    return text ? *text : "";
}

// Ends the process if the message contains the poison.
void swallow(std::string_view message) {
    const std::string hash = poison();
    if (!hash.empty() && message.find(hash) != std::string_view::npos) std::abort();
}

// Of several processes one succeeds, and the others never read an incomplete file.
void choose_poison(std::string_view unit) {
    UnitReader reader(kinds());
    const Result<Unit> read = reader.read(unit);
    if (!read) return;
    const std::string own = kPoisonFile + std::to_string(::getpid());
    std::ofstream(own) << hex_text(genome_hash(*read->requests.front().genome));
    std::error_code exists;
    std::filesystem::create_hard_link(own, kPoisonFile, exists);
}

class MortalQueue final : public SoundQueue {
public:
    using SoundQueue::SoundQueue;
    std::vector<Delivery> fetch(std::size_t most, milliseconds longest) override {
        std::vector<Delivery> deliveries = SoundQueue::fetch(most, longest);
        for (const Delivery& delivery : deliveries) {
            if (poison().empty()) choose_poison(delivery.unit.body);
            swallow(delivery.unit.body);
        }
        return deliveries;
    }
};

std::unique_ptr<WorkerQueue> with_fault(std::string_view fault,
                                        std::unique_ptr<WorkerQueue> queue) {
    if (fault == "flips") return std::make_unique<FlippingQueue>(std::move(queue));
    if (fault == "slow") return std::make_unique<SlowQueue>(std::move(queue));
    if (fault == "silent") return std::make_unique<SilentQueue>(std::move(queue));
    if (fault == "dies") return std::make_unique<MortalQueue>(std::move(queue));
    return queue;
}

ExitStatus compute_unit(std::string_view fault) {
    if (fault == "refuses") return fail(Error{"not today"});
    const std::string question{std::istreambuf_iterator<char>(std::cin), {}};
    swallow(question);
    const Result<std::string> answer = answer_question(question, kinds());
    return answer ? print_result(*answer) : fail(answer.error());
}

ExitStatus work(std::string_view fault, const std::string& url, const std::string& name) {
    const Result<ClusterAddress> address = cluster_address({.servers = url});
    if (!address) return fail(address.error());
    auto queue = connect_worker(*address);
    if (!queue) return fail(queue.error());
    const auto faulty = with_fault(fault, *std::move(queue));
    WorkerOptions options;
    options.id = random_id();
    options.name = name;
    options.threads.priority = ThreadPriority::kNormal;  // other tests do not starve it
    options.say = [](std::string_view words) { say(words); };
    work_for_cluster(kinds(), *faulty, options, {});
    return ExitStatus::kDone;
}

}  // namespace

int main(int argc, char** argv) {
    const char* named = std::getenv("CAMBRIAN_FAULT");  // NOLINT(concurrency-mt-unsafe)
    const std::string fault = named == nullptr ? "" : named;
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 2 || words[0] != "worker")
        return static_cast<int>(run_command_line(argc, argv));
    if (const Status prepared = prepare_process(); !prepared)
        return static_cast<int>(fail(prepared.error(), ExitStatus::kFailed));
    const ExitStatus status =
        words[1] == "--unit" ? compute_unit(fault) : work(fault, words[1], words.back());
    return static_cast<int>(status);
}
