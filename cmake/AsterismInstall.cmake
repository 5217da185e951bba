# Install and export: find_package(Asterism) gives Asterism::predicates (component predicates) and
# Asterism::asterism (component mesher). The layout needs no registry and can be moved.
include(CMakePackageConfigHelpers)

set(asterism_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Asterism)

set(predicates_libraries asterism_predicates)
set(mesher_libraries asterism)
if(BUILD_SHARED_LIBS)
  list(APPEND predicates_libraries asterism_predicates_shared)
  list(APPEND mesher_libraries asterism_shared)
endif()
install(TARGETS ${predicates_libraries} EXPORT AsterismPredicates)
install(EXPORT AsterismPredicates NAMESPACE Asterism:: DESTINATION ${asterism_cmake_dir})
if(TARGET asterism)
  install(TARGETS ${mesher_libraries} EXPORT AsterismMesher)
  install(EXPORT AsterismMesher NAMESPACE Asterism:: DESTINATION ${asterism_cmake_dir})
endif()

# Installs the public headers, by list, and no others. None of them includes a header of another
# library (tests/build/check_public_headers.py).
file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/public_headers.txt public_headers REGEX "^[^#]")
foreach(header IN LISTS public_headers)
  if(header MATCHES "^mesh/" AND NOT TARGET asterism)
    continue()
  endif()
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header}
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/asterism/${folder})
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
