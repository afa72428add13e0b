# Ipopt ships no CMake package, and its pkg-config line asks for lapack and blas that a bare machine lacks.
# Defines Ipopt::Ipopt.
find_path(IPOPT_INCLUDE_DIR IpTNLP.hpp PATH_SUFFIXES coin coin-or)
find_library(IPOPT_LIBRARY ipopt)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Ipopt REQUIRED_VARS IPOPT_LIBRARY IPOPT_INCLUDE_DIR)
if(Ipopt_FOUND AND NOT TARGET Ipopt::Ipopt)
  add_library(Ipopt::Ipopt UNKNOWN IMPORTED)
  set_target_properties(Ipopt::Ipopt PROPERTIES
    IMPORTED_LOCATION "${IPOPT_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${IPOPT_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS HAVE_CSTDDEF)
endif()
mark_as_advanced(IPOPT_INCLUDE_DIR IPOPT_LIBRARY)
