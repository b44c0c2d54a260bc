#pragma once

// Takes random choices from the bytes of an input; after the last byte, all are zero.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace cambrian::test {

class ByteSource {
public:
    explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

    bool empty() const { return bytes_.empty(); }

    // Returns a number with the bits of the next bytes.
    template <class Number>
    Number number() {
        Number number{};
        const std::string_view part = take(sizeof(Number));
        std::memcpy(&number, part.data(), part.size());
        return number;
    }
    // `count` must be at least 1.
    std::size_t below(std::size_t count) { return number<std::uint16_t>() % count; }
    std::string_view text() { return take(number<std::uint16_t>()); }

private:
    std::string_view take(std::size_t count) {
        const std::string_view part = bytes_.substr(0, count);
        bytes_.remove_prefix(part.size());
        return part;
    }

    std::string_view bytes_;
};

}  // namespace cambrian::test
