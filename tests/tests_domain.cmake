# Domains, metric fields, file formats and pictures.
find_package(Threads REQUIRED)

asterism_test(test_domain
  SOURCES mesh/domain_check_test.cpp mesh/domain_parts_test.cpp mesh/domain_sources_test.cpp)
asterism_test(test_metric_field SOURCES mesh/metric_field_test.cpp LINK Threads::Threads)
asterism_test(test_metric_field_graded SOURCES mesh/gradation_grid_test.cpp mesh/metric_field_graded_test.cpp)
asterism_test(test_io SOURCES io/medit_test.cpp io/poly_test.cpp io/write_mesh_test.cpp)
asterism_test(test_draw SOURCES draw/picture_test.cpp)

# meshio comes as a Debian package, which the system's own Python finds.
add_executable(write_sample io/write_sample.cpp)
asterism_configure(write_sample)
target_link_libraries(write_sample PRIVATE asterism)
add_test(NAME "io: files read back by meshio"
         COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/io/read_with_meshio.py
                 $<TARGET_FILE:write_sample>)

find_program(ASTERISM_FREEFEM FreeFem++-nw)
if(ASTERISM_FREEFEM)
  add_test(NAME "io: files read back by FreeFEM"
           COMMAND /usr/bin/python3 ${CMAKE_CURRENT_SOURCE_DIR}/io/read_with_freefem.py
                   $<TARGET_FILE:write_sample> ${ASTERISM_FREEFEM})
else()
  message(STATUS "FreeFem++-nw (Debian: freefem++) not found: its read-back test is left out")
endif()
