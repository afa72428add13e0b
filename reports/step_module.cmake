# STEP assemblies: a module that the reports load where one is wanted, built where OpenCASCADE is found (Debian:
# scripts/bootstrap step). Its name bears the version, so that a program loads none but its own.
set(KEMPE_WITH_OCCT AUTO CACHE STRING "Write STEP assemblies with OpenCASCADE: AUTO, ON or OFF")
set_property(CACHE KEMPE_WITH_OCCT PROPERTY STRINGS AUTO ON OFF)
set(module kempe-step-${PROJECT_VERSION})
set_property(SOURCE drawings/step_assembly.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  KEMPE_STEP_MODULE="${module}${CMAKE_SHARED_MODULE_SUFFIX}")

if(KEMPE_WITH_OCCT STREQUAL AUTO)
  find_package(Occt QUIET)
elseif(KEMPE_WITH_OCCT)
  find_package(Occt REQUIRED)
endif()
if(KEMPE_WITH_OCCT AND Occt_FOUND)
  add_library(kempe_step MODULE drawings/step_assembly_backend.cpp)
  set_target_properties(kempe_step PROPERTIES PREFIX "" OUTPUT_NAME ${module}
    LIBRARY_OUTPUT_DIRECTORY ${KEMPE_MODULE_DIR} CXX_VISIBILITY_PRESET hidden)
  target_compile_features(kempe_step PRIVATE cxx_std_20)
  target_include_directories(kempe_step PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(kempe_step PRIVATE Occt::Step)
  kempe_warnings(kempe_step)
endif()
