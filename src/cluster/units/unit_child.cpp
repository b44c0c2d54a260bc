#include "cluster/units/unit_child.h"

#include "cluster/messages/judging_settings.h"
#include "cluster/messages/message_text.h"
#include "cluster/messages/work_queue.h"
#include "cluster/units/unit_work.h"

namespace cambrian {
namespace {

const MessageKind kQuestionKind{"cambrian-question", 1};

struct Question {
    std::size_t settings_bytes = 0;
};

template <class Archive, class Described>
void describe_question(Archive& archive, Described& question) {
    archive.integer("settingsBytes", question.settings_bytes, 0.0,
                    static_cast<double>(kMostSettingsBytes));
}

}  // namespace

std::string question_text(std::string_view settings, std::string_view unit) {
    const Question question{settings.size()};
    std::string text = write_message(
        kQuestionKind, question,
        [](JsonWriter& writer, const Question& each) { describe_question(writer, each); });
    return text.append("\n").append(settings).append(unit);
}

Result<std::string> answer_question(std::string_view question, const EvolutionKinds& kinds) {
    constexpr JsonLimits kQuestionLimits{.bytes = 1'000, .depth = 2, .values = 8, .keys = 8};
    const std::size_t end = question.find('\n');
    const Result<Question> head = read_message<Question>(
        kQuestionKind, question.substr(0, end), kQuestionLimits,
        [](JsonReader& reader, Question& each) { describe_question(reader, each); });
    if (!head) return head.error();
    const std::string_view rest =
        end == std::string_view::npos ? std::string_view{} : question.substr(end + 1);
    if (rest.size() < head->settings_bytes) return Error{kQuestionKind.format + ": it is cut off"};
    const Result<ExperimentSettings> settings =
        read_judging_settings(rest.substr(0, head->settings_bytes), kQuestionKind.format, kinds);
    if (!settings) return settings.error();
    UnitReader reader(kinds);
    const Result<Unit> unit = reader.read(rest.substr(head->settings_bytes));
    if (!unit) return unit.error();
    return write_unit_result(compute_unit(*unit, *settings, kinds, {}));
}

}  // namespace cambrian
