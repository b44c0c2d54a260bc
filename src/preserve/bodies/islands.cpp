#include "preserve/bodies/islands.h"

#include <algorithm>
#include <numeric>

namespace cambrian {

void Islands::begin(std::span<const SceneSize> sizes, const SceneSize& most) {
    parents_.resize(sizes.size());
    std::iota(parents_.begin(), parents_.end(), 0U);
    images_.assign(sizes.size(), {});
    sizes_.assign(sizes.begin(), sizes.end());
    most_ = most;
    crowded_.clear();
}

std::uint32_t Islands::find(std::uint32_t body) const {
    while (parents_[body] != body)
        body = parents_[body];
    return body;
}

Periods Islands::image(std::uint32_t body) const {
    Periods sum;
    for (; parents_[body] != body; body = parents_[body])
        sum = sum + images_[body];
    return sum;
}

void Islands::join(std::vector<NearPair> pairs) {
    std::sort(pairs.begin(), pairs.end());
    for (const NearPair& pair : pairs) {
        const std::uint32_t a = find(pair.first);
        const std::uint32_t b = find(pair.second);
        const Periods apart = image(pair.first) + pair.image - image(pair.second);
        if (a == b) {
            if (apart != Periods{}) crowded_.push_back(pair);
            continue;
        }
        SceneSize both = sizes_[a];
        both += sizes_[b];
        if (!both.fits(most_)) {
            crowded_.push_back(pair);
            continue;
        }
        parents_[std::max(a, b)] = std::min(a, b);
        images_[std::max(a, b)] = a < b ? apart : Periods{} - apart;
        sizes_[std::min(a, b)] = both;
    }
}

}  // namespace cambrian
