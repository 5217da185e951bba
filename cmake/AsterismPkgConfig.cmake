# asterism_pkg_config(NAME LIBRARY DESCRIPTION NEEDS...): installs NAME.pc, which can be moved with the
# prefix. NEEDS are the flags that the static library brings along; without a shared one there is
# nothing else to link, so they stand where plain `pkg-config --libs` finds them.
function(asterism_pkg_config pc_name library pc_description)
  set(pc_folder ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH pc_to_prefix ${pc_folder} ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" pc_to_prefix ${pc_to_prefix})
  # Below the prefix, unless the folder was named from the root on.
  foreach(folder IN ITEMS INCLUDEDIR LIBDIR)
    set(pc_${folder} ${CMAKE_INSTALL_${folder}})
    if(NOT IS_ABSOLUTE ${pc_${folder}})
      string(PREPEND pc_${folder} "\${prefix}/")
    endif()
  endforeach()
  set(pc_libs -l${library})
  list(JOIN ARGN " " pc_private)
  if(NOT BUILD_SHARED_LIBS)
    set(pc_libs "${pc_libs} ${pc_private}")
    set(pc_private)
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/cmake/asterism.pc.in ${PROJECT_BINARY_DIR}/${pc_name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc_name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# The standard library that the compiler was found to link, which C programs have to name.
set(of_predicates -lstdc++ -lm)
if("c++" IN_LIST CMAKE_CXX_IMPLICIT_LINK_LIBRARIES)
  set(of_predicates -lc++ -lm)
endif()
if(ASTERISM_EXACT STREQUAL "gmp")
  list(PREPEND of_predicates -lgmp)
endif()
asterism_pkg_config(asterism-predicates asterism_predicates
                    "Exact predicates of anisotropic triangulation" ${of_predicates})
if(TARGET asterism)
  set(of_threads)
  if(ASTERISM_THREADS)
    set(of_threads -pthread)
  endif()
  asterism_pkg_config(asterism asterism "Certified anisotropic triangle meshes"
                      -lasterism_predicates -lfmt ${of_threads} -lz -lmpfr ${of_predicates})
endif()
