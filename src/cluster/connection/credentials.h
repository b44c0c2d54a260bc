#pragma once

// How a program proves to the server who it is.

#include "core/result.h"

#include <string>

namespace cambrian {

struct Credentials {
    std::string user;  // empty: the file is one that NATS's own tools write
    std::string password;
};

// Reads a credentials file: user = "..." and password = "..." as TOML, or a file with a signed
// token and key (*.creds), which only the connection reads. Fails, naming the file, on anything
// else.
Result<Credentials> read_credentials(const std::string& file);

}  // namespace cambrian
