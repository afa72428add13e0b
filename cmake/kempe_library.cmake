# kempe::kempe, the library that is installed: what all rooms compile, in one file, behind the headers of include/kempe.
# Shared or static by BUILD_SHARED_LIBS.
get_property(rooms GLOBAL PROPERTY KEMPE_ROOMS)
get_property(outside GLOBAL PROPERTY KEMPE_OUTSIDE)
list(TRANSFORM rooms REPLACE "(.+)" "$<TARGET_OBJECTS:kempe_\\1>" OUTPUT_VARIABLE objects)
# The rooms themselves, and libraries of headers alone, leave nothing to link.
list(FILTER outside EXCLUDE REGEX "^kempe::|^tl::expected$|^nlohmann_json::|^Eigen3::")
list(REMOVE_DUPLICATES outside)

add_library(kempe ${objects} ${KEMPE_LIBM_OBJECT})
add_library(kempe::kempe ALIAS kempe)
set_target_properties(kempe PROPERTIES LINKER_LANGUAGE CXX VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(kempe INTERFACE cxx_std_20)
target_include_directories(kempe INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(kempe INTERFACE Eigen3::Eigen)
if(BUILD_SHARED_LIBS)
  list(TRANSFORM outside REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")  # who links the library need not have them
endif()
target_link_libraries(kempe PRIVATE ${outside} Threads::Threads)
