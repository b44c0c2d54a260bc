#pragma once

// Problems of a connection, as messages for users. Each message is reported once, and their number
// is limited.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace cambrian {

class Complaints {
public:
    void add(const std::string& words) {
        if (said_.size() >= kMost) return;
        if (std::find(said_.begin(), said_.end(), words) != said_.end()) return;
        said_.push_back(words);
        untold_.push_back(words);
    }
    // Returns the messages added since the last call.
    std::vector<std::string> take() { return std::exchange(untold_, {}); }

private:
    static constexpr std::size_t kMost = 100;

    std::vector<std::string> said_;
    std::vector<std::string> untold_;
};

}  // namespace cambrian
