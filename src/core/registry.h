#pragma once

// A registry of kinds (sensors, goals, selection methods...) in order of registration. A Kind has a
// member `id`, a text that files contain and that never changes. Registries are filled before any
// thread starts and are then shared by const reference.

#include "core/assert.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace cambrian {

template <class Kind>
class Registry {
public:
    void add(Kind kind) {
        CAMBRIAN_ASSERT(!index_of(kind.id), "a kind's id is registered once");
        kinds_.push_back(std::move(kind));
    }
    std::span<const Kind> all() const { return kinds_; }
    std::size_t size() const { return kinds_.size(); }
    const Kind& operator[](std::size_t index) const {
        CAMBRIAN_ASSERT(index < kinds_.size(), "kind index in range");
        return kinds_[index];
    }
    std::optional<std::size_t> index_of(std::string_view id) const {
        for (std::size_t i = 0; i < kinds_.size(); ++i) {
            if (kinds_[i].id == id) return i;
        }
        return std::nullopt;
    }
    const Kind* find(std::string_view id) const {
        const auto index = index_of(id);
        return index ? &kinds_[*index] : nullptr;
    }

private:
    std::vector<Kind> kinds_;
};

}  // namespace cambrian
