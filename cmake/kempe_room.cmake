# kempe_room(NAME SOURCES ... USES ... [PRIVATE_USES ...])
# One room of the house: the static library kempe_NAME (alias kempe::NAME), its warnings and its include roots.
function(kempe_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;USES;PRIVATE_USES" ${ARGN})
  add_library(kempe_${name} STATIC ${ROOM_SOURCES})
  add_library(kempe::${name} ALIAS kempe_${name})
  set_target_properties(kempe_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(kempe_${name} PUBLIC cxx_std_20)
  target_include_directories(kempe_${name} PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(kempe_${name} PUBLIC ${ROOM_USES} PRIVATE ${ROOM_PRIVATE_USES})
  kempe_warnings(kempe_${name})
  set_property(GLOBAL APPEND PROPERTY KEMPE_ROOMS ${name})
  set_property(GLOBAL APPEND PROPERTY KEMPE_OUTSIDE ${ROOM_USES} ${ROOM_PRIVATE_USES})
endfunction()

function(kempe_warnings target)
  # g++ 12 reports false overlaps in std::string concatenation (its bug 105651).
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    $<$<BOOL:${KEMPE_WERROR}>:-Werror>)
endfunction()

# kempe_tests(NAME SOURCES ... USES ...): one GoogleTest program a room, each case known to CTest.
function(kempe_tests name)
  cmake_parse_arguments(T "" "" "SOURCES;USES" ${ARGN})
  add_executable(kempe_${name}_tests ${T_SOURCES})
  target_link_libraries(kempe_${name}_tests PRIVATE ${T_USES} GTest::gtest_main)
  target_compile_definitions(kempe_${name}_tests PRIVATE
    KEMPE_SOURCE_DIR="${PROJECT_SOURCE_DIR}" KEMPE_BINARY_DIR="${PROJECT_BINARY_DIR}")
  kempe_warnings(kempe_${name}_tests)
  gtest_discover_tests(kempe_${name}_tests DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 900)
endfunction()
