#pragma once

// The objects of --json reports, on one line.

#include <string>
#include <vector>

namespace cambrian {

struct JsonMember {
    std::string key;
    std::string value;  // as it is in the text: quoted if it is one
};
using JsonMembers = std::vector<JsonMember>;

std::string json_object(const JsonMembers& members);
std::string json_list(const std::vector<std::string>& values);
inline std::string json_truth(bool truth) {
    return truth ? "true" : "false";
}

}  // namespace cambrian
