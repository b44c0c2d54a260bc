#include "preserve/museum.h"

#include <algorithm>

namespace cambrian {

std::uint64_t living_members(const Residents& residents, std::uint64_t lineage) {
    return static_cast<std::uint64_t>(
        std::count_if(residents.begin(), residents.end(),
                      [&](const auto& each) { return each->life.lineage == lineage; }));
}

const Resident* most_fertile(const Residents& residents) {
    const auto found = std::max_element(
        residents.begin(), residents.end(),
        [](const auto& a, const auto& b) { return a->life.children < b->life.children; });
    return found == residents.end() || (*found)->life.children == 0 ? nullptr : found->get();
}

void add_pieces(std::vector<MuseumPiece>& museum, std::span<const MuseumPiece> later) {
    for (const MuseumPiece& piece : later) {
        const bool is_known =
            std::any_of(museum.begin(), museum.end(), [&](const MuseumPiece& other) {
                return other.number == piece.number && other.reason == piece.reason;
            });
        if (!is_known) museum.push_back(piece);
    }
}

}  // namespace cambrian
