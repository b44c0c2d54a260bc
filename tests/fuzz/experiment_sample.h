#pragma once

// The experiment that fuzzing damages: small, but with something in every table.

#include <filesystem>
#include <string>

namespace cambrian::test {

// The bytes of its file, in small pages so that there are many. folder: to make it in.
std::string sample_experiment(const std::filesystem::path& folder);

}  // namespace cambrian::test
