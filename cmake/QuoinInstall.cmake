# SPDX-License-Identifier: Apache-2.0
# Library, headers, command and the files that find_package(quoin) reads.
include(CMakePackageConfigHelpers)

target_compile_options(quoin INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>)
install(TARGETS quoin EXPORT quoin_targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS quoin_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES "${PROJECT_SOURCE_DIR}/docs/man/quoin.1" DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES "${PROJECT_SOURCE_DIR}/scripts/completion/quoin.bash"
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME quoin)
install(FILES "${PROJECT_SOURCE_DIR}/scripts/completion/_quoin" DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/quoin" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(EXPORT quoin_targets NAMESPACE quoin:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/quoin)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/quoin-config.cmake.in" "${PROJECT_BINARY_DIR}/quoin-config.cmake"
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/quoin)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/quoin-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/quoin-config.cmake" "${PROJECT_BINARY_DIR}/quoin-config-version.cmake"
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/quoin)
