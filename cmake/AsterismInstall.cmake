# Install and export: find_package(Asterism) gives Asterism::predicates (component predicates) and
# Asterism::asterism (component mesher). The layout needs no registry and can be moved.
include(CMakePackageConfigHelpers)

set(asterism_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Asterism)

install(TARGETS asterism_predicates EXPORT AsterismPredicates)
install(TARGETS asterism EXPORT AsterismMesher)
install(EXPORT AsterismPredicates NAMESPACE Asterism:: DESTINATION ${asterism_cmake_dir})
install(EXPORT AsterismMesher NAMESPACE Asterism:: DESTINATION ${asterism_cmake_dir})

foreach(folder core predicates kernels mesh)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/asterism
          FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/AsterismConfig.cmake.in
  ${PROJECT_BINARY_DIR}/AsterismConfig.cmake
  INSTALL_DESTINATION ${asterism_cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/AsterismConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/AsterismConfig.cmake
              ${PROJECT_BINARY_DIR}/AsterismConfigVersion.cmake
        DESTINATION ${asterism_cmake_dir})
