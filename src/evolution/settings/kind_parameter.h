#pragma once

// Parameters that only one kind of something has, a selection method for example. The kind's own
// file defines them; settings keep their values by key.

#include <functional>
#include <map>
#include <string>
#include <variant>

namespace cambrian {

using ParameterValues =
    std::map<std::string, std::variant<bool, int, double, std::string>, std::less<>>;

template <class Value>
struct KindParameter {
    const char* key;
    Value standard;  // used if the settings have no value

    Value of(const ParameterValues& values) const {
        const auto found = values.find(key);
        return found == values.end() ? standard : std::get<Value>(found->second);
    }
    // Returns the value in the settings; it is added if they have none.
    Value& in(ParameterValues& values) const {
        return std::get<Value>(values.try_emplace(key, standard).first->second);
    }
};

}  // namespace cambrian
