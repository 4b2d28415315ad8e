# SPDX-License-Identifier: GPL-3.0-or-later
# Installation for C++ programs: library, headers and the CMake package samcontact (cpp/examples/hertz).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/samcontact")
install(TARGETS samcontact EXPORT samcontactTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY cpp/include/samcontact DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.hpp")
install(EXPORT samcontactTargets NAMESPACE samcontact:: DESTINATION "${package}")
configure_package_config_file(cmake/samcontactConfig.cmake.in
  "${CMAKE_CURRENT_BINARY_DIR}/samcontactConfig.cmake" INSTALL_DESTINATION "${package}"
  NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may change the declarations in headers.
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/samcontactConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/FindFFTW3.cmake "${CMAKE_CURRENT_BINARY_DIR}/samcontactConfig.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/samcontactConfigVersion.cmake" DESTINATION "${package}")
