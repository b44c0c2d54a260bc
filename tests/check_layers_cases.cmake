# check_layers.cmake accepts a tree whose includes point down, and fails on each kind of fault.
cmake_minimum_required(VERSION 3.25)
set(ROOT ${WORK}/check_layers_cases)

# Two layers, of which the upper has two folders and a root.
function(write_tree)
  file(REMOVE_RECURSE ${ROOT})
  file(WRITE ${ROOT}/src/README.md "| 0 | `low` | – |\n| 1 | `high` | low |\n")
  file(WRITE ${ROOT}/src/high/README.md "| `base` | – |\n| `top/part` | base |\n| `.` | all |\n")
  file(WRITE ${ROOT}/src/low/low.h "#pragma once\n")
  file(WRITE ${ROOT}/src/high/base/base.h "#include \"low/low.h\"\n")
  file(WRITE ${ROOT}/src/high/top/part/part.h "#include \"high/base/base.h\"\n")
  file(WRITE ${ROOT}/src/high/root.h "#include \"high/top/part/part.h\"\n")
endfunction()

# expect(<exit status> <part of the message>)
function(expect status words)
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${ROOT} -P ${CHECK}
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[\n ]+" " " said "${said}")
  string(FIND "${said}" "${words}" found)
  if(NOT result EQUAL status OR found EQUAL -1)
    message(SEND_ERROR "expected status ${status} and '${words}', got ${result}: ${said}")
  endif()
endfunction()

write_tree()
expect(0 "4 files checked")

file(WRITE ${ROOT}/src/low/low.h "#include \"high/root.h\"\n")
expect(1 "points from low to high")

write_tree()
file(WRITE ${ROOT}/src/high/base/base.h "#include \"high/top/part/part.h\"\n")
expect(1 "points from high/base to high/top/part")

write_tree()
file(WRITE ${ROOT}/src/high/top/part/part.h "#include \"high/root.h\"\n")
expect(1 "points from high/top/part to high/.")

write_tree()
file(WRITE ${ROOT}/src/high/other/other.h "#pragma once\n")
expect(1 "folder 'other' has no row in src/high/README.md")

write_tree()
file(WRITE ${ROOT}/src/high/README.md "| `base` | top/part |\n| `top/part` | – |\n| `.` | all |\n")
expect(1 "'base' may include 'top/part', which has no row above it")

file(REMOVE_RECURSE ${ROOT})
