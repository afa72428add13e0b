# cminpack's own CMake files differ between its packagers; its pkg-config line does not always find the header.
# Defines Cminpack::cminpack.
find_path(CMINPACK_INCLUDE_DIR cminpack.h PATH_SUFFIXES cminpack-1 cminpack)
find_library(CMINPACK_LIBRARY cminpack)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Cminpack REQUIRED_VARS CMINPACK_LIBRARY CMINPACK_INCLUDE_DIR)
if(Cminpack_FOUND AND NOT TARGET Cminpack::cminpack)
  add_library(Cminpack::cminpack UNKNOWN IMPORTED)
  set_target_properties(Cminpack::cminpack PROPERTIES
    IMPORTED_LOCATION "${CMINPACK_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${CMINPACK_INCLUDE_DIR}")
endif()
mark_as_advanced(CMINPACK_INCLUDE_DIR CMINPACK_LIBRARY)
