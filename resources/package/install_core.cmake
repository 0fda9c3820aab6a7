# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the headers of core and what find_package(Rivulet) reads; the libraries are installed by
# rivulet_add_module.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Rivulet)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rivulet
  COMPONENT development FILES_MATCHING PATTERN "*.h" PATTERN "*_windows.h" EXCLUDE)
install(EXPORT RivuletTargets NAMESPACE rivulet:: DESTINATION ${package_folder}
  COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/RivuletConfig.cmake.in
  ${PROJECT_BINARY_DIR}/RivuletConfig.cmake INSTALL_DESTINATION ${package_folder})
# Before 1.0 a minor version may change what others build on.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RivuletConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/RivuletConfig.cmake
  ${PROJECT_BINARY_DIR}/RivuletConfigVersion.cmake
  DESTINATION ${package_folder} COMPONENT development)
