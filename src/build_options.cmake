# Compile options of all our code: cambrian_options (language, floating point, sanitizers)
# and cambrian_warnings; and cambrian_layer(), which declares one layer's static library.

add_library(cambrian_options INTERFACE)
target_compile_features(cambrian_options INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)
# Same bits everywhere: no contraction into fused multiply-add, and no packet maths in Eigen, whose
# width would decide the order of its sums.
target_compile_options(cambrian_options INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
target_compile_definitions(cambrian_options INTERFACE EIGEN_DONT_VECTORIZE
  $<$<CONFIG:Debug>:CAMBRIAN_TICK_ASSERTS>)
# Flags of the caller may neither reorder sums nor fuse. Where the processor they name has the instructions,
# gcc makes fused pairs of a sum and a difference of products (vfmaddsub) whatever -ffp-contract says, so
# it must not know them.
include(CheckCXXSourceCompiles)
string(TOUPPER "${CMAKE_BUILD_TYPE}" configuration)
set(CMAKE_REQUIRED_FLAGS "${CMAKE_CXX_FLAGS_${configuration}}")
check_cxx_source_compiles("#ifdef __FAST_MATH__\n#error\n#endif\nint main() {}" CAMBRIAN_MATHS_IS_EXACT)
if(NOT CAMBRIAN_MATHS_IS_EXACT)
  message(FATAL_ERROR "With CMAKE_CXX_FLAGS, here \"${CMAKE_CXX_FLAGS}\", or those of the configuration, results "
    "would depend on the machine. Leave out -ffast-math and -Ofast.")
endif()
check_cxx_source_compiles("#if defined __FMA__ || defined __FMA4__ || defined __AVX512F__\n#error\n#endif\nint main() {}"
  CAMBRIAN_FUSES_NOTHING)
if(NOT CAMBRIAN_FUSES_NOTHING)
  target_compile_options(cambrian_options INTERFACE -mno-fma -mno-fma4 -mno-avx512f)
endif()
unset(CMAKE_REQUIRED_FLAGS)
# gcc spends a tenth of its time on collecting garbage unless it may fill a gigabyte (in kB) first.
target_compile_options(cambrian_options INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1000000>)
if(CAMBRIAN_SANITIZE)
  # Fuzzing runs for hours.
  string(REGEX MATCH "fuzzer" fuzzing "${CAMBRIAN_SANITIZE}")
  target_compile_options(cambrian_options INTERFACE
    -fsanitize=${CAMBRIAN_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # The address sanitizer itself stops at what is beyond an object; this check takes a fifth of the time
    # to compile.
    -fno-sanitize=object-size
    -g1  # lines of a report; more takes a third of the time to compile
    $<IF:$<BOOL:${fuzzing}>,-O2,-O1>)
  # lld links what sanitizers make so large four times as fast.
  target_link_options(cambrian_options INTERFACE -fsanitize=${CAMBRIAN_SANITIZE} -fuse-ld=lld)
endif()

add_library(cambrian_warnings INTERFACE)
target_compile_options(cambrian_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast
  -Wnon-virtual-dtor -Woverloaded-virtual -Wdouble-promotion -Wimplicit-fallthrough
  -Werror
  $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond;-Wlogical-op;-Wuseless-cast;-Wcast-align=strict>)
# gcc 12 sees null pointers, uninitialised values and overlapping or endless copies in standard strings,
# vectors and variants where there are none as soon as it optimises; clang-tidy's analyzer looks for them
# instead.
target_compile_options(cambrian_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)

# All symbols of libraries are bound when a program starts; then nothing can redirect them any more.
target_link_options(cambrian_options INTERFACE $<$<CONFIG:Release>:LINKER:-z,now>)

# cambrian_guard(<target>) makes the release build of code that reads what strangers wrote stop at accesses
# beyond an object. Layers that compute a trial are left out: they get checked data, and each access counts.
function(cambrian_guard target)
  if(NOT CAMBRIAN_SANITIZE)
    target_compile_options(${target} PRIVATE
      $<$<CONFIG:Release>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2;-D_GLIBCXX_ASSERTIONS>)
  endif()
endfunction()

# cambrian_layer(<name> [WAITS] SOURCES <file>... [DEPENDS <layer or third_party target>...])
# declares the library cambrian_<name>; includes are written from src/. A layer that WAITS for people,
# files or other programs most of its time is compiled with less optimisation, in less time. Of an inline
# function that many objects hold the linker keeps the first. A program with the property
# CAMBRIAN_LAYERS_FIRST, whose own objects are less optimised, links the layers before them.
function(cambrian_layer name)
  cmake_parse_arguments(LAYER "WAITS" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(cambrian_${name} STATIC ${LAYER_SOURCES})
  target_include_directories(cambrian_${name} PUBLIC ${CMAKE_SOURCE_DIR}/src)
  target_link_libraries(cambrian_${name} PUBLIC ${LAYER_DEPENDS} cambrian_options PRIVATE cambrian_warnings)
  set(link_whole LINKER:--whole-archive,$<TARGET_FILE:cambrian_${name}>,--no-whole-archive)
  target_link_options(cambrian_${name} INTERFACE
    $<$<BOOL:$<TARGET_PROPERTY:CAMBRIAN_LAYERS_FIRST>>:${link_whole}>)
  if(LAYER_WAITS)
    target_compile_options(cambrian_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()
