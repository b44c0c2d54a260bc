# Used header-only: the package's shared library assumes what persist/settings/toml.h changes.
find_path(TOMLPLUSPLUS_INCLUDE_DIR toml++/toml.h REQUIRED)
add_library(cambrian_tomlplusplus_headers INTERFACE)
target_include_directories(cambrian_tomlplusplus_headers SYSTEM INTERFACE ${TOMLPLUSPLUS_INCLUDE_DIR})
cambrian_wrap(tomlplusplus cambrian_tomlplusplus_headers)
