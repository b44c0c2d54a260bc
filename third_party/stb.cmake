find_path(STB_INCLUDE_DIR stb/stb_image_write.h REQUIRED)
add_library(cambrian_stb_headers INTERFACE)
target_include_directories(cambrian_stb_headers SYSTEM INTERFACE ${STB_INCLUDE_DIR})
cambrian_wrap(stb cambrian_stb_headers)
