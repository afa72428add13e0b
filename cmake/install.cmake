include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY KEMPE_ROOMS)
foreach(room IN LISTS rooms)
  install(TARGETS kempe_${room} EXPORT kempe-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kempe/${room} FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(TARGETS kempe EXPORT kempe-targets)
# Modules lie below the libraries; the program looks there, and so do programs that link the installed library.
file(RELATIVE_PATH from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/kempe)
set_target_properties(kempe_program PROPERTIES INSTALL_RPATH "$ORIGIN/${from_program}")
target_link_options(kempe_reports INTERFACE $<INSTALL_INTERFACE:LINKER:-rpath,$<INSTALL_PREFIX>/${CMAKE_INSTALL_LIBDIR}/kempe>)
if(TARGET kempe_step)
  install(TARGETS kempe_step LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/kempe)
endif()
install(TARGETS kempe_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT kempe-targets NAMESPACE kempe:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/kempe)

configure_package_config_file(cmake/kempe-config.cmake.in ${PROJECT_BINARY_DIR}/kempe-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/kempe)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kempe-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kempe-config.cmake ${PROJECT_BINARY_DIR}/kempe-config-version.cmake
  cmake/FindIpopt.cmake cmake/FindCminpack.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/kempe)
