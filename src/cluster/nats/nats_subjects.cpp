#include "cluster/nats/nats_subjects.h"

#include "core/text/parsed_number.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::size_t kHashDigits = 16;
constexpr int kTokensOfUnit = 3;  // run, generation and unit

std::optional<std::uint64_t> id_of(std::string_view text) {
    return text.size() == kHashDigits ? parse_hex(text) : std::nullopt;
}

// Removes and returns the text before the next dot.
std::string_view token(std::string_view& text) {
    const std::size_t end = std::min(text.find('.'), text.size());
    const std::string_view first = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return first;
}

bool is_token(std::string_view text) {
    return !text.empty() && text.find('.') == std::string_view::npos;
}

std::string generation_name(std::uint64_t run, std::uint32_t generation) {
    return fmt::format("{}.{}", hex_text(run), generation);
}

}  // namespace

std::string NatsSubjects::unit_name(const UnitId& unit) {
    return fmt::format("{}.{}", generation_name(unit.run, unit.generation), unit.unit);
}

std::string NatsSubjects::work_of(std::uint64_t run) const {
    return fmt::format("{}.work.{}.>", cluster_, hex_text(run));
}

std::string NatsSubjects::results_of(std::uint64_t run) const {
    return fmt::format("{}.result.{}.>", cluster_, hex_text(run));
}

std::string NatsSubjects::work_of(std::uint64_t run, std::uint32_t generation) const {
    return fmt::format("{}.work.{}.>", cluster_, generation_name(run, generation));
}

std::string NatsSubjects::results_of(std::uint64_t run, std::uint32_t generation) const {
    return fmt::format("{}.result.{}.>", cluster_, generation_name(run, generation));
}

std::optional<UnitId> NatsSubjects::unit_of(std::string_view subject) const {
    if (token(subject) != cluster_) return std::nullopt;
    const std::string_view kind = token(subject);
    if (kind != "work" && kind != "result") return std::nullopt;
    const auto run = id_of(token(subject));
    const auto generation = parsed_number<std::uint32_t>(token(subject));
    const bool result = kind == "result";
    const auto unit = parsed_number<std::uint32_t>(result ? token(subject) : subject);
    if (!run || !generation || !unit) return std::nullopt;
    if (result && !is_token(subject)) return std::nullopt;
    return UnitId{*run, *generation, *unit};
}

std::string NatsSubjects::login_of(std::string_view subject) const {
    if (token(subject) != cluster_) return "";
    const std::string_view kind = token(subject);
    const bool result = kind == "result";
    if (!result && (kind != "hello" || token(subject) != "worker")) return "";
    for (int skipped = 0; result && skipped < kTokensOfUnit; ++skipped)
        token(subject);
    const std::string_view login = token(subject);
    return result == subject.empty() ? std::string(login) : "";
}

std::string NatsSubjects::stop(std::uint64_t run) const {
    return fmt::format("{}.stop.{}", cluster_, hex_text(run));
}

std::optional<std::uint64_t> NatsSubjects::stopped_run(std::string_view subject) const {
    if (token(subject) != cluster_ || token(subject) != "stop") return std::nullopt;
    return id_of(subject);
}

}  // namespace cambrian
