#include "cluster/messages/hello_text.h"

#include "cluster/messages/message_text.h"
#include "cluster/messages/text_for_people.h"
#include "cluster/messages/work_queue.h"
#include "genome/gene_fields.h"
#include "simulator/simulator_version.h"

#include <limits>

namespace cambrian {
namespace {

constexpr std::size_t kMostRefusals = 10;
constexpr std::size_t kMostTrials = 32;
constexpr std::size_t kLongestReasonOfHello = 160;
constexpr double kMostCores = 100'000.0;
const MessageKind kHelloKind{"cambrian-hello", 1};
const std::vector<std::string> kRoles = {"worker", "coordinator"};

constexpr FieldRule kRate{.name = "rate",
                          .key = "rate",
                          .low = 0.0,
                          .high = std::numeric_limits<double>::max(),
                          .fallback = 0.0};

template <class Archive, class Said>
void describe_hello(Archive& archive, Said& hello) {
    archive.choice("role", hello.role, kRoles, "role");
    archive.digest("id", hello.id);
    archive.text("name", hello.name, kLongestName);
    archive.integer("cores", hello.cores, 0.0, kMostCores);
    archive.text("simulator", hello.simulator, kLongestVersion);
    archive.digest("proof", hello.proof);
    archive.integer("busy", hello.busy, 0.0, kMostCores);
    archive.flag("leaving", hello.leaving);
    archive.real("units", hello.units_per_second, kRate);
    archive.real("creatures", hello.creatures_per_second, kRate);
    archive.real("work", hello.work_per_second, kRate);
    archive.text("refused", hello.refused, kLongestReasonOfHello);
    archive.list("refusals", hello.refusals, 0, kMostRefusals, JsonLayout::kCompact,
                 [](Archive& inner, auto& refusal) {
                     inner.digest("worker", refusal.worker);
                     inner.text("reason", refusal.reason, kLongestReasonOfHello);
                 });
    archive.list("trials", hello.trials, 0, kMostTrials, JsonLayout::kCompact,
                 [](Archive& inner, auto& trial) {
                     inner.text("name", trial.name, kLongestName);
                     inner.digest("digest", trial.digest);
                 });
}

Hello cut_to_size(Hello hello) {
    hello.name = text_for_people(hello.name, kLongestName);
    hello.simulator = text_for_people(hello.simulator, kLongestName);
    hello.refused = text_for_people(hello.refused, kLongestReasonOfHello);
    if (hello.refusals.size() > kMostRefusals) hello.refusals.resize(kMostRefusals);
    for (Refusal& refusal : hello.refusals)
        refusal.reason = text_for_people(refusal.reason, kLongestReasonOfHello);
    for (auto& trial : hello.trials)
        trial.name = text_for_people(trial.name, kLongestName);
    return hello;
}

}  // namespace

const std::string& role_word(Hello::Role role) {
    return kRoles[static_cast<std::size_t>(role)];
}

Hello introduction(Hello::Role role, std::uint64_t id, const std::string& name, std::size_t cores,
                   std::uint64_t proof) {
    Hello hello;
    hello.role = role;
    hello.id = id;
    hello.name = name;
    hello.cores = static_cast<int>(cores);
    hello.simulator = kSimulatorVersion;
    hello.proof = proof;
    return hello;
}

std::string hello_text(const Hello& hello) {
    const Hello said = cut_to_size(hello);
    return write_message(kHelloKind, said, [](JsonWriter& writer, const Hello& each) {
        describe_hello(writer, each);
    });
}

Result<Hello> parse_hello(std::string_view text) {
    constexpr JsonLimits kHelloLimits{
        .bytes = kMostHelloBytes, .depth = 4, .values = 400, .keys = 32};
    Result<Hello> hello =
        read_message<Hello>(kHelloKind, text, kHelloLimits,
                            [](JsonReader& reader, Hello& each) { describe_hello(reader, each); });
    if (!hello) return hello;
    return cut_to_size(*std::move(hello));
}

}  // namespace cambrian
