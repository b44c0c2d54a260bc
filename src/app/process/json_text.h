#pragma once

// JSON objects on one line, for the --json reports.

#include <string>
#include <vector>

namespace cambrian {

struct JsonMember {
    std::string key;
    std::string value;  // JSON text of the value; strings include their quotes
};
using JsonMembers = std::vector<JsonMember>;

std::string json_object(const JsonMembers& members);
std::string json_list(const std::vector<std::string>& values);
inline std::string json_truth(bool truth) {
    return truth ? "true" : "false";
}

}  // namespace cambrian
