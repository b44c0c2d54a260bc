#pragma once

// Authentication of a program to the server.

#include "core/result.h"

#include <string>

namespace cambrian {

struct Credentials {
    std::string user;  // empty for a file in the format of NATS's own tools
    std::string password;
};

// Reads a credentials file: user = "..." and password = "..." as TOML, or a file with a signed
// token and a key (*.creds), which only the connection reads. Fails for anything else; the message
// names the file.
Result<Credentials> read_credentials(const std::string& file);

}  // namespace cambrian
