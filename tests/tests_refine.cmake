# Stars, consistency and refinement.
asterism_test(test_star
  SOURCES mesh/star_test.cpp mesh/star_ties_test.cpp mesh/star_boundary_test.cpp
          mesh/consistency_test.cpp mesh/star_internal_test.cpp mesh/star_confirmation_test.cpp
          mesh/audit_meshes.cpp)
asterism_test(test_refine
  SOURCES mesh/refine_constructions_test.cpp mesh/refine_test.cpp mesh/refine_domains_test.cpp
          mesh/domain_random_test.cpp mesh/refine_wedges_test.cpp mesh/audit_meshes.cpp)
asterism_test(test_improvement
  SOURCES mesh/improvement_test.cpp mesh/audit_meshes.cpp
  LINK tbb)
asterism_test(test_fitting
  SOURCES mesh/fitting_test.cpp)
# What is near, and the refinement that rests on it.
asterism_test(test_local
  SOURCES mesh/local_index_test.cpp mesh/given_distances_test.cpp mesh/statistics_test.cpp
          mesh/thin_metric_test.cpp mesh/many_vertices_test.cpp mesh/audit_meshes.cpp)
asterism_test(test_relaxation
  SOURCES mesh/relaxation_test.cpp
  LINK tbb)
asterism_test(test_guaranteed
  SOURCES mesh/guaranteed_test.cpp mesh/extreme_numbers_test.cpp
  LINK tbb)
