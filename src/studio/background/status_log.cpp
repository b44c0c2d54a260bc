#include "studio/background/status_log.h"

#include "core/text/pretty_text.h"
#include "persist/json/json_text.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

std::string json_value(const StatusLog::Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return quoted_text(*text);
    if (const auto* flag = std::get_if<bool>(&value)) return json_truth(*flag);
    return fmt::format("{:.10g}", *std::get_if<double>(&value));
}

}  // namespace

StatusLog::StatusLog(const std::filesystem::path& path) {
    if (!path.empty()) file_.open(path, std::ios::app);
}

void StatusLog::write(const std::string& event, std::initializer_list<Field> fields) {
    if (!file_.is_open()) return;
    JsonMembers members = {{"event", quoted_text(event)}};
    if (frame_ > 0) members.push_back({"frame", std::to_string(frame_)});
    for (const auto& [name, value] : fields)
        members.push_back({name, json_value(value)});
    file_ << json_object(members, JsonLayout::kDense) << "\n" << std::flush;
}

}  // namespace cambrian
