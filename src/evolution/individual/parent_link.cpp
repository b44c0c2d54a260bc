#include "evolution/individual/parent_link.h"

#include "evolution/individual/individual.h"

#include <vector>

namespace cambrian {

// The outermost destructor releases the ancestors one by one; inner ones only pass their parent to
// it.
ParentLink::~ParentLink() {
    if (parent_ == nullptr) return;
    thread_local std::vector<IndividualPtr>* leaving = nullptr;
    if (leaving != nullptr) {
        leaving->push_back(std::move(parent_));
        return;
    }
    std::vector<IndividualPtr> line;
    leaving = &line;
    line.push_back(std::move(parent_));
    while (!line.empty()) {
        const IndividualPtr last = std::move(line.back());
        line.pop_back();
    }
    leaving = nullptr;
}

}  // namespace cambrian
