#pragma once

// The link from an individual to its parent. A living individual keeps its line of descent, and
// lines that died out are freed. Lines grow without limit, so the destructor does not recurse.

#include <memory>
#include <utility>

namespace cambrian {

struct Individual;

class ParentLink {
public:
    ParentLink() = default;  // no parent
    explicit ParentLink(std::shared_ptr<const Individual> parent) : parent_(std::move(parent)) {}
    ParentLink(const ParentLink&) = default;
    ParentLink(ParentLink&&) noexcept = default;
    ParentLink& operator=(ParentLink other) noexcept {
        std::swap(parent_, other.parent_);
        return *this;
    }
    ~ParentLink();

    // Null where the known line ends.
    const std::shared_ptr<const Individual>& get() const { return parent_; }

private:
    std::shared_ptr<const Individual> parent_;
};

}  // namespace cambrian
