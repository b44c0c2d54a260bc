#pragma once

// 64-bit FNV-1a over bytes, for digests of motions and genomes and for checks of files. It will
// never change, and does not depend on the machine's byte order.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace cambrian {

class Hash64 {
public:
    void add_byte(std::uint8_t byte) { state_ = (state_ ^ byte) * kPrime; }
    void add(std::uint64_t word) {
        for (int shift = 0; shift < 64; shift += 8) {
            add_byte(static_cast<std::uint8_t>(word >> shift));
        }
    }
    // Adds the bits of the number; -0 and 0 differ.
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(std::string_view text) {
        for (const char letter : text)
            add_byte(static_cast<std::uint8_t>(letter));
        add(std::uint64_t{text.size()});
    }

    std::uint64_t value() const { return state_; }

private:
    static constexpr std::uint64_t kPrime = 0x100000001b3ULL;
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace cambrian
