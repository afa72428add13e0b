# kempe_room(NAME SOURCES ... USES ... [PRIVATE_USES ...] [JOINED ...])
# One room of the house, or a part of one that others do without: the static library kempe_NAME (alias kempe::NAME), its
# warnings and its include roots.
function(kempe_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;USES;PRIVATE_USES;JOINED" ${ARGN})
  add_library(kempe_${name} STATIC ${ROOM_SOURCES})
  add_library(kempe::${name} ALIAS kempe_${name})
  set_target_properties(kempe_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)  # a shared library shows what include/kempe marks
  target_compile_features(kempe_${name} PUBLIC cxx_std_20)
  target_include_directories(kempe_${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(kempe_${name} PUBLIC ${ROOM_USES} kempe_libm PRIVATE ${ROOM_PRIVATE_USES})
  kempe_warnings(kempe_${name})
  target_compile_options(kempe_${name} PRIVATE $<$<BOOL:${KEMPE_LIGHT}>:-O1>)
  kempe_whole_folders(kempe_${name} ${ROOM_JOINED})
  # No contraction: a compiler for a machine with fused multiply-add rounds every product as the others do, so that the same
  # spec gives the same bytes there.
  target_compile_options(kempe_${name} PRIVATE -ffp-contract=off)
  set_property(GLOBAL APPEND PROPERTY KEMPE_ROOMS ${name})
  set_property(GLOBAL APPEND PROPERTY KEMPE_OUTSIDE ${ROOM_USES} ${ROOM_PRIVATE_USES})
endfunction()

# kempe_whole_folders(TARGET [FOLDER ...]): with KEMPE_UNITY the sources of a folder are compiled as one, their headers and
# templates once: a fresh build takes a part of the CPU time, a changed file more. A folder that is named here is compiled with
# all that is below it (`.`: the whole target), but for what a folder named later holds; `one,other`: both as one. What is
# compiled as one must not give two helpers one name (that one shadows another is no fault). Files that include CGAL or the like
# (*_backend.cpp) stay apart, alone unless their room groups them.
function(kempe_whole_folders target)
  if(NOT KEMPE_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    set(group ${folder})
    foreach(joined IN LISTS ARGN)
      string(REPLACE "," ";" folders ${joined})
      foreach(one IN LISTS folders)
        if(one STREQUAL "." OR folder STREQUAL one OR folder MATCHES "^${one}/")
          set(group ${joined})
        endif()
      endforeach()
    endforeach()
    if(NOT IS_ABSOLUTE ${source} AND NOT source MATCHES "_backend\\.cpp$")
      string(MAKE_C_IDENTIFIER "sources_${group}" group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endif()
  endforeach()
  # g++ collects its garbage after every few hundred megabytes: an eighth of its time on sources of this size, whose peak it
  # hardly lowers.
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=1000000>")
endfunction()

# kempe_lightly_optimised(TARGET): with KEMPE_UNITY a target that only reads options and writes files, or only asks others (a
# test), is compiled with -O1, which takes a third less time; with KEMPE_LIGHT with -Og, which takes a fifth less than that. No
# number changes: these options leave floating-point arithmetic alone.
function(kempe_lightly_optimised target)
  target_compile_options(${target} PRIVATE $<$<BOOL:${KEMPE_UNITY}>:$<IF:$<BOOL:${KEMPE_LIGHT}>,-Og,-O1>>)
endfunction()

# kempe_common_headers(TARGET): with KEMPE_UNITY the headers that nearly every test includes are compiled once for all tests of
# the target: two thirds of a small test's time. Each test still names what it uses; a build without KEMPE_UNITY tells who does not.
function(kempe_common_headers target)
  if(KEMPE_UNITY)
    target_precompile_headers(${target} PRIVATE <gmock/gmock.h> <gtest/gtest.h> <Eigen/Core> <algorithm> <cmath> <complex>
      <filesystem> <fstream> <functional> <random> <string> <vector>)
    # So that ccache takes them: it looks at the header's contents, and clang writes no time into it.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
      "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
  endif()
endfunction()

function(kempe_warnings target)
  # g++ 12 reports false overlaps in std::string concatenation (its bug 105651).
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${KEMPE_UNITY}>:-Wno-shadow>
    $<$<AND:$<BOOL:${KEMPE_UNITY}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
    $<$<BOOL:${KEMPE_WERROR}>:-Werror>
    $<$<AND:$<BOOL:${KEMPE_LIGHT}>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>  # without the passes that would see more
    # What g++ 12 finds after inlining is often false: told, but no error.
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-error=maybe-uninitialized;-Wno-error=array-bounds;-Wno-error=stringop-overflow;-Wno-error=stringop-overread;-Wno-error=dangling-pointer;-Wno-error=free-nonheap-object>")
endfunction()

# kempe_tests(NAME SOURCES ... USES ...): one GoogleTest program a room, each case known to CTest. OpenBLAS, which may stand behind
# Ipopt, would keep a second core busy at each start (app/one_blas_thread.cpp).
function(kempe_tests name)
  cmake_parse_arguments(T "" "" "SOURCES;USES" ${ARGN})
  add_executable(kempe_${name}_tests ${T_SOURCES})
  target_link_libraries(kempe_${name}_tests PRIVATE ${T_USES} GTest::gtest_main)
  target_compile_definitions(kempe_${name}_tests PRIVATE
    KEMPE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" KEMPE_BINARY_DIR="${PROJECT_BINARY_DIR}")
  kempe_warnings(kempe_${name}_tests)
  kempe_common_headers(kempe_${name}_tests)
  kempe_lightly_optimised(kempe_${name}_tests)
  kempe_whole_folders(kempe_${name}_tests)
  gtest_discover_tests(kempe_${name}_tests NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 900 ENVIRONMENT OPENBLAS_NUM_THREADS=1)
endfunction()
