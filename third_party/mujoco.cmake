# Only the benchmarks compare with it. Debian's package configuration also wants OpenGL, which
# nothing here draws with.
find_path(MUJOCO_INCLUDE_DIR mujoco/mujoco.h REQUIRED)
find_library(MUJOCO_LIBRARY mujoco REQUIRED)
add_library(cambrian_mujoco_library INTERFACE)
target_include_directories(cambrian_mujoco_library SYSTEM INTERFACE ${MUJOCO_INCLUDE_DIR})
target_link_libraries(cambrian_mujoco_library INTERFACE ${MUJOCO_LIBRARY})
cambrian_wrap(mujoco cambrian_mujoco_library)
