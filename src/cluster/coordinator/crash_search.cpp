#include "cluster/coordinator/crash_search.h"

#include "cluster/messages/judging_settings.h"
#include "cluster/messages/unit_text.h"
#include "persist/creature/creature_file.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace cambrian {

Apart CrashSearch::compute(std::span<const EvaluationRequest> requests,
                           const std::stop_token& stop) const {
    Apart apart;
    compute_part(requests, stop, apart);
    return apart;
}

void CrashSearch::compute_part(std::span<const EvaluationRequest> requests,
                               const std::stop_token& stop, Apart& apart) const {
    if (stop.stop_requested() || !apart.failure.empty() || !apart.trouble.empty()) return;
    UnitWriter writer(kinds_);
    const Result<ChildEnd> end = child_(question_text(settings_, writer.write({}, requests)), stop);
    if (stop.stop_requested()) return;
    if (!end) {
        apart.trouble = end.error().message;
    } else if (end->crashed && requests.size() == 1) {
        apart.failure = describe(requests.front(), end->cause);
    } else if (end->crashed) {
        const std::size_t half = requests.size() / 2;
        compute_part(requests.first(half), stop, apart);
        compute_part(requests.subspan(half), stop, apart);
    } else {
        take_answer(end->output, requests, apart);
    }
}

void CrashSearch::take_answer(std::string_view output, std::span<const EvaluationRequest> requests,
                              Apart& apart) {
    Result<UnitResult> answer = parse_unit_result(output);
    if (!answer) {
        apart.trouble = answer.error().message;
        return;
    }
    const auto same_slot = [](const SlotResult& result, const EvaluationRequest& request) {
        return result.slot == request.slot;
    };
    if (std::equal(answer->results.begin(), answer->results.end(), requests.begin(), requests.end(),
                   same_slot))
        std::move(answer->results.begin(), answer->results.end(),
                  std::back_inserter(apart.results));
    else
        apart.trouble = "the process that was to evaluate creatures answered something else";
}

std::string CrashSearch::describe(const EvaluationRequest& request,
                                  const std::string& cause) const {
    const std::filesystem::path file =
        folder_ / fmt::format("crash-{}.creature.json", hex_text(genome_hash(*request.genome)));
    const Result<ExperimentSettings> settings =
        read_judging_settings(settings_, "settings of the run", kinds_);
    const auto world =
        std::make_shared<const ExperimentSettings>(settings ? *settings : ExperimentSettings());
    const Status written = save_creature(file, {unjudged(request.genome, world)}, kinds_);
    return fmt::format(
        "the genome in {} ends the process that evaluates it ({}): a fault of this program, please "
        "report it with that file. The run stops here, since without this creature it would not be "
        "the same run.{}",
        file.string(), cause,
        written ? "" : " The file could not be written: " + written.error().message);
}

}  // namespace cambrian
