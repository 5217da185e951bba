# The auditor and its certificate. It includes nothing of the stars and the refinement.
find_package(nlohmann_json REQUIRED)
target_sources(asterism PRIVATE
  audit.cpp
  audit_angles.cpp
  audit_boundary.cpp
  audit_context.cpp
  audit_domain.cpp
  audit_edges.cpp
  audit_fans.cpp
  audit_piece_tree.cpp
  audit_regions.cpp
  audit_site_tree.cpp
  audit_stars.cpp
  audit_star_filter.cpp
  audit_values.cpp
  audit_voronoi.cpp
  audit_voronoi_arc.cpp
  audit_voronoi_exact.cpp
  certificate.cpp
  certificate_json.cpp
  certificate_verify.cpp)
set_source_files_properties(certificate.cpp PROPERTIES
  COMPILE_DEFINITIONS "ASTERISM_VERSION=\"${PROJECT_VERSION}\"")
# Header-only and used inside alone: nobody who links the library needs it.
target_link_libraries(asterism PRIVATE $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> mpfr gmp)
