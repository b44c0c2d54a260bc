#pragma once

// Authentication of a program to the server.

#include "core/result.h"

#include <string>

namespace cambrian {

// The login of a program without credentials.
inline constexpr const char* kNoLogin = "anyone";

struct Credentials {
    std::string user;  // empty for a file in the format of NATS's own tools
    std::string password;
    // Who the server takes the program for, as a part of subjects: the user, with '_' for
    // everything but letters, digits, '-' and '_'; of a signed token, the public key that it is
    // made for.
    std::string login = kNoLogin;
};

// Reads a credentials file: user = "..." and password = "..." as TOML, or a file with a signed
// token and a key (*.creds), which only the connection reads. Fails for anything else; the message
// names the file.
Result<Credentials> read_credentials(const std::string& file);

// Whether other users of this machine can read the file.
bool others_can_read(const std::string& file);

}  // namespace cambrian
