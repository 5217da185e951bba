# asterism_shared_library(TARGET OF LIBRARY...): TARGET is a shared library with the objects of the static
# LIBRARY... beside it, under the same file name. OF is the one it stands for; the others are those that
# it contains as well, so that nothing internal has to be visible between two libraries.
function(asterism_shared_library target of)
  add_library(${target} SHARED)
  foreach(library IN ITEMS ${of} ${ARGN})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
  # Links the libraries that the objects need. The archives themselves add nothing.
  target_link_libraries(${target} PRIVATE ${of})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set(script ${PROJECT_SOURCE_DIR}/cmake/exported.map)
  target_link_options(${target} PRIVATE LINKER:--version-script=${script} LINKER:-Bsymbolic-functions)
  # Threads of the pool stay in the library's code until the process ends, so closing it leaves it in place.
  target_link_options(${target} PRIVATE LINKER:-z,nodelete)
  if(NOT ASTERISM_SANITIZE)  # the program brings the sanitizer's run-time library
    target_link_options(${target} PRIVATE LINKER:--no-undefined)
  endif()
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${of} LINKER_LANGUAGE CXX LINK_DEPENDS ${script}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
endfunction()

# Defines the names that programs link: the shared libraries where they are built. The static ones
# then have names of their own.
function(asterism_name_library name static)
  if(BUILD_SHARED_LIBS)
    set_target_properties(${static} PROPERTIES EXPORT_NAME ${name}_static)
    set_target_properties(${static}_shared PROPERTIES EXPORT_NAME ${name})
    add_library(Asterism::${name} ALIAS ${static}_shared)
    add_library(Asterism::${name}_static ALIAS ${static})
  else()
    set_target_properties(${static} PROPERTIES EXPORT_NAME ${name})
    add_library(Asterism::${name} ALIAS ${static})
  endif()
endfunction()

if(BUILD_SHARED_LIBS)
  asterism_shared_library(asterism_predicates_shared asterism_predicates)
endif()
asterism_name_library(predicates asterism_predicates)
if(TARGET asterism)
  if(BUILD_SHARED_LIBS)
    asterism_shared_library(asterism_shared asterism asterism_predicates)
  endif()
  asterism_name_library(asterism asterism)
endif()
