find_package(CGAL REQUIRED)
# Looks inside the kernels, so it links what their headers include.
asterism_predicates_test(core_test
  SOURCES core/numbers_test.cpp core/integer_test.cpp kernels/exact_roots_test.cpp
  LINK CGAL::CGAL gmp)
target_compile_options(core_test PRIVATE -frounding-math)
asterism_predicates_test(kernels_test
  SOURCES kernels/tiers_test.cpp kernels/environment_test.cpp kernels/filter_bounds_test.cpp
          kernels/error_constants_test.cpp kernels/fixed_width_test.cpp
          kernels/batch_test.cpp)
asterism_predicates_test(star_gap_test
  SOURCES kernels/star_gap_test.cpp kernels/star_gap_bounds_test.cpp
  LINK CGAL::CGAL gmp)
target_compile_options(star_gap_test PRIVATE -frounding-math)
# Replaces operator new, so a program of its own.
asterism_predicates_test(allocation_test SOURCES kernels/allocation_test.cpp LINK gmp)
