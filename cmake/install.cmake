include(CMakePackageConfigHelpers)

install(TARGETS kempe EXPORT kempe-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/kempe DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
if(TARGET kempe_program)
  install(TARGETS kempe_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(TARGET kempe_manual)
    install(DIRECTORY ${PROJECT_BINARY_DIR}/app/share/ DESTINATION ${CMAKE_INSTALL_DATADIR})
  endif()
  install(FILES out/studio.html DESTINATION ${CMAKE_INSTALL_DATADIR}/kempe OPTIONAL)  # if scripts/studio has built it
  install(FILES ${KEMPE_CHECKER} DESTINATION ${CMAKE_INSTALL_DATADIR}/kempe/proof)
endif()
install(EXPORT kempe-targets NAMESPACE kempe:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/kempe)

configure_package_config_file(cmake/kempe-config.cmake.in ${PROJECT_BINARY_DIR}/kempe-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/kempe)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kempe-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kempe-config.cmake ${PROJECT_BINARY_DIR}/kempe-config-version.cmake
  cmake/FindIpopt.cmake cmake/FindCminpack.cmake cmake/FindHaru.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/kempe)
