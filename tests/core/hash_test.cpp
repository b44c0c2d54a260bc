#include "core/hash.h"

#include "support/catch.h"

#include <limits>
#include <string_view>

using namespace cambrian;

namespace {

std::uint64_t hash_of_bytes(std::string_view bytes) {
    Hash64 hash;
    for (const char byte : bytes)
        hash.add_byte(static_cast<std::uint8_t>(byte));
    return hash.value();
}

template <class T>
std::uint64_t hash_of(T value) {
    Hash64 hash;
    hash.add(value);
    return hash.value();
}

}  // namespace

TEST_CASE("the hash of bytes is 64-bit FNV-1a", "[core][hash]") {
    // Test vectors of the authors' reference code (draft-eastlake-fnv).
    CHECK(hash_of_bytes("") == 0xcbf29ce484222325ULL);
    CHECK(hash_of_bytes("a") == 0xaf63dc4c8601ec8cULL);
    CHECK(hash_of_bytes("b") == 0xaf63df4c8601f1a5ULL);
    CHECK(hash_of_bytes("foobar") == 0x85944171f73967e8ULL);
}

TEST_CASE("words are hashed low byte first on every machine", "[core][hash]") {
    CHECK(hash_of(std::uint64_t{0x0807060504030201ULL}) ==
          hash_of_bytes(std::string_view("\1\2\3\4\5\6\7\10", 8)));
}

TEST_CASE("a number is hashed by its bits", "[core][hash]") {
    CHECK(hash_of(1.0) == hash_of(std::uint64_t{0x3ff0000000000000ULL}));
    CHECK(hash_of(0.0) != hash_of(-0.0));
    CHECK(hash_of(1.0) != hash_of(1.0 + std::numeric_limits<double>::epsilon()));
}

TEST_CASE("texts next to each other do not run together in the hash", "[core][hash]") {
    Hash64 first;
    first.add(std::string_view("ab"));
    first.add(std::string_view("c"));
    Hash64 second;
    second.add(std::string_view("a"));
    second.add(std::string_view("bc"));
    CHECK(first.value() != second.value());
}
