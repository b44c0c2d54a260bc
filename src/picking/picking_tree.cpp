#include "picking/picking_tree.h"

#include <fmt/core.h>

#include <string>
#include <utility>

namespace cambrian {

std::optional<std::uint32_t> PickingTree::next() const {
    return empty() ? std::nullopt : forward_[current_];
}

void PickingTree::add(GridNode node) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    node.number = number;
    node.parent.reset();
    if (!empty()) node.parent = current_;
    nodes_.push_back(std::make_shared<const GridNode>(std::move(node)));
    forward_.emplace_back();
    go_to(number);
}

bool PickingTree::back() {
    if (empty() || !current().parent) return false;
    go_to(*current().parent);
    return true;
}

bool PickingTree::forward() {
    const std::optional<std::uint32_t> child = next();
    if (child) go_to(*child);
    return child.has_value();
}

Status PickingTree::visit(std::uint32_t number) {
    if (number >= size()) return Error{fmt::format("there is no grid {}", number)};
    go_to(number);
    return {};
}

void PickingTree::go_to(std::uint32_t number) {
    current_ = number;
    for (std::uint32_t at = number; nodes_[at]->parent; at = *nodes_[at]->parent)
        forward_[*nodes_[at]->parent] = at;
}

}  // namespace cambrian
