#pragma once

// An area around 0 0 whose opposite edges may meet. Everything in it has images, which are so many
// widths and heights away.

#include "math/bounds.h"
#include "math/types.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace cambrian {

// An image of something, so many widths to the right of it and heights above it.
struct Periods {
    std::int32_t x = 0, y = 0;

    friend bool operator==(const Periods&, const Periods&) = default;
    friend bool operator<(const Periods& a, const Periods& b) {
        return std::tie(a.x, a.y) < std::tie(b.x, b.y);
    }
    friend Periods operator+(const Periods& a, const Periods& b) { return {a.x + b.x, a.y + b.y}; }
    friend Periods operator-(const Periods& a, const Periods& b) { return {a.x - b.x, a.y - b.y}; }
};

struct Torus {
    double width = 0.0, height = 0.0;  // m; 0 where edges do not meet

    bool meets() const { return width > 0.0 || height > 0.0; }
    // Returns how far an image is away, in m.
    Vec3 shift_of(const Periods& image) const { return {image.x * width, image.y * height, 0.0}; }
    // Returns the image of the area in which a point is.
    Periods image_of(const Vec3& point) const {
        return {whole_periods(point.x(), width), whole_periods(point.y(), height)};
    }
    // Returns the shortest vector from something to an image of what the given one leads to or, of
    // a point, its image in the area.
    Vec3 shortest(const Vec3& way) const {
        if (!meets()) return way;
        return way - shift_of(image_of(way));
    }
    // Calls visit(shift), in m, for each image of a box that meets another box; where edges do not
    // meet, for the box itself.
    template <class Visit>
    void visit_images(const Bounds& of, const Bounds& at, Visit visit) const {
        if (!meets()) {
            visit(Vec3(Vec3::Zero()));
            return;
        }
        const Periods first{least_image(of.high.x(), at.low.x(), width),
                            least_image(of.high.y(), at.low.y(), height)};
        const Periods last{-least_image(-of.low.x(), -at.high.x(), width),
                           -least_image(-of.low.y(), -at.high.y(), height)};
        for (Periods image = first; image.y <= last.y; ++image.y) {
            for (image.x = first.x; image.x <= last.x; ++image.x)
                visit(shift_of(image));
        }
    }

private:
    static std::int32_t whole(double periods) {
        return static_cast<std::int32_t>(std::clamp(periods, -1e9, 1e9));
    }
    static std::int32_t whole_periods(double coordinate, double period) {
        return period > 0.0 ? whole(std::floor(coordinate / period + 0.5)) : 0;
    }
    // Returns the least image at which an upper end is not below a lower one.
    static std::int32_t least_image(double high, double low, double period) {
        return period > 0.0 ? whole(std::ceil((low - high) / period)) : 0;
    }
};

}  // namespace cambrian
