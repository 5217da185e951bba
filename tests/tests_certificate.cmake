asterism_test(audit_test
  SOURCES mesh/audit_meshes.cpp mesh/audit_topology_test.cpp mesh/audit_angles_test.cpp
          mesh/audit_stars_test.cpp mesh/audit_internal_test.cpp mesh/audit_number_test.cpp
          mesh/audit_voronoi_test.cpp
          abuse/caller_environment.cpp
  LINK mpfr)
asterism_test(metric_field_sampled_test
  SOURCES mesh/audit_meshes.cpp mesh/metric_field_sampled_test.cpp)
asterism_test(certificate_test
  SOURCES mesh/audit_meshes.cpp mesh/certificate_test.cpp)
