# The OpenGL 3.3 core loader, generated at build time by Debian's glad; nothing of it is in the tree.
find_program(GLAD glad REQUIRED)
set(glad_dir ${CMAKE_BINARY_DIR}/generated/glad)
add_custom_command(
  OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h
  COMMAND ${GLAD} --reproducible --quiet --api gl:core=3.3 --out-path ${glad_dir} c
  COMMENT "Generating the OpenGL loader" VERBATIM)
add_library(cambrian_glad STATIC ${glad_dir}/src/gl.c)
target_include_directories(cambrian_glad SYSTEM PUBLIC ${glad_dir}/include)
target_link_libraries(cambrian_glad PUBLIC ${CMAKE_DL_LIBS})
cambrian_wrap(glad cambrian_glad)
