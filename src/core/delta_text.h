#pragma once

// Text compressed as its difference from a similar text, the base: a Zstandard frame (RFC 8878)
// whose prefix is the base.

#include "core/result.h"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace cambrian {

class DeltaEncoder {
public:
    DeltaEncoder();
    // The result is valid until the next call.
    std::string_view encode(std::string_view text, std::string_view base);

private:
    struct Free {
        void operator()(ZSTD_CCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_CCtx_s, Free> context_;
    std::string buffer_;
};

class DeltaDecoder {
public:
    DeltaDecoder();
    // `size` is the number of bytes of the text. Fails if the encoded bytes give another number. A
    // base other than that of the encoder gives another text or fails.
    Result<std::string> decode(std::string_view bytes, std::string_view base, std::size_t size);

private:
    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_DCtx_s, Free> context_;
};

}  // namespace cambrian
