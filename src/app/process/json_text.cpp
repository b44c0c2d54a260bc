#include "app/process/json_text.h"

namespace cambrian {

std::string json_object(const JsonMembers& members) {
    std::string text;
    for (const JsonMember& member : members) {
        text.append(text.empty() ? "{\"" : ", \"").append(member.key);
        text.append("\": ").append(member.value);
    }
    return text.empty() ? "{}" : text + "}";
}

std::string json_list(const std::vector<std::string>& values) {
    std::string text = "[";
    for (const std::string& value : values)
        text.append(text.size() > 1 ? ", " : "").append(value);
    return text + "]";
}

}  // namespace cambrian
