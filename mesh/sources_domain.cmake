find_package(fmt REQUIRED)
find_package(muparser REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)

target_sources(asterism PRIVATE
  domain.cpp
  domain_check.cpp
  domain_closure.cpp
  domain_contains.cpp
  domain_faces.cpp
  domain_graph.cpp
  domain_names.cpp
  domain_parts.cpp
  domain_sources.cpp
  draw/canvas.cpp
  draw/picture.cpp
  io/file_output.cpp
  io/medit_reader.cpp
  io/medit_solution.cpp
  io/medit_writer.cpp
  io/poly.cpp
  io/text_scanner.cpp
  io/vtu.cpp
  io/write_mesh.cpp
  gradation_grid.cpp
  gradation_sweep.cpp
  metric_algebra.cpp
  metric_angle.cpp
  metric_field.cpp
  metric_field_expression.cpp
  metric_field_featured.cpp
  metric_field_graded.cpp
  metric_field_relaxed.cpp
  metric_field_sampled.cpp
  metric_field_layered.cpp)
target_link_libraries(asterism PRIVATE fmt::fmt muparser::muparser PkgConfig::cairo)
