#pragma once

#include <filesystem>

namespace cambrian {

// Returns the folder of the sample creatures, settings and help pages. It belongs to the installed
// program (<prefix>/share/cambrian for <prefix>/bin/cambrian), else to the sources it was built
// from.
std::filesystem::path assets_folder();

}  // namespace cambrian
