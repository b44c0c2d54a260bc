#pragma once

#include <filesystem>

namespace cambrian {

// Where the sample creatures, settings and help pages are: beside an installed program
// (<prefix>/share/cambrian for <prefix>/bin/cambrian), else in the sources it was built from.
std::filesystem::path assets_folder();

}  // namespace cambrian
