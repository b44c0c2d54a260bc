#include "studio/background/status_log.h"

#include "core/pretty_text.h"

namespace cambrian {
namespace {

std::string json_value(const StatusLog::Value& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return json_text(*text);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    return format("%.10g", *std::get_if<double>(&value));
}

}  // namespace

StatusLog::StatusLog(const std::filesystem::path& path) {
    if (!path.empty()) file_.open(path, std::ios::app);
}

void StatusLog::write(const std::string& event, std::initializer_list<Field> fields) {
    if (!file_.is_open()) return;
    std::string line = "{\"event\":" + json_text(event);
    if (frame_ > 0) line += ",\"frame\":" + std::to_string(frame_);
    for (const auto& [name, value] : fields)
        line += ",\"" + std::string(name) + "\":" + json_value(value);
    file_ << line << "}\n" << std::flush;
}

std::string json_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char letter : text) {
        const auto byte = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            quoted += '\\';
            quoted += letter;
        } else if (byte < 0x20) {
            quoted += format("\\u%04x", static_cast<unsigned>(byte));
        } else {
            quoted += letter;
        }
    }
    return quoted + "\"";
}

}  // namespace cambrian
