# Compiles with flags that a user may give: those that allow fused operations must not lead to any, and
# those that reorder sums are refused.
cmake_minimum_required(VERSION 3.25)

# configure(<flags> [<argument>...]) sets status and said.
function(configure flags)
  file(REMOVE_RECURSE ${WORK}/build)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -G "${GENERATOR}" -S ${SOURCE} -B ${WORK}/build -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${flags} ${ARGN}
    RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  set(status ${status} PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()

if(PROCESSOR STREQUAL "x86_64")
  foreach(flags "" "-mfma" "-march=x86-64-v3" "-march=x86-64-v4" "-march=bdver2")
    configure("${flags}")
    if(NOT status EQUAL 0)
      message(FATAL_ERROR "flags '${flags}' were refused: ${said}")
    endif()
    execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build
      RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
    file(GLOB_RECURSE assembly ${WORK}/build/*.s)
    if(NOT status EQUAL 0 OR NOT assembly)
      message(FATAL_ERROR "flags '${flags}' do not compile: ${said}")
    endif()
    file(STRINGS ${assembly} fused REGEX "vfn?m(add|sub)")
    if(fused)
      message(SEND_ERROR "flags '${flags}' make fused operations: ${fused}")
    endif()
  endforeach()
endif()

function(expect_refusal)
  configure(${ARGN})
  if(status EQUAL 0 OR NOT said MATCHES "Leave out -ffast-math")
    message(SEND_ERROR "flags '${ARGN}' were not refused: ${said}")
  endif()
endfunction()
expect_refusal("-ffast-math")
expect_refusal("-Wall" -DCMAKE_CXX_FLAGS_RELEASE=-Ofast)
