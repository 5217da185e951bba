# asterism_test(name SOURCES ... LINK ...)
find_package(CGAL REQUIRED)

add_library(asterism_oracle STATIC
  oracle/arc_sections.cpp
  oracle/conic.cpp
  oracle/exact_numbers.cpp
  oracle/oracle_insertion.cpp
  oracle/oracle_intersections.cpp
  oracle/oracle_pointwise.cpp
  property/drawing.cpp
  property/generators.cpp)
asterism_configure(asterism_oracle)
target_include_directories(asterism_oracle PUBLIC ${PROJECT_BINARY_DIR}/include)
target_link_libraries(asterism_oracle PRIVATE CGAL::CGAL gmp mpfr)
# CGAL's own checks make the algebraic kernel several times slower.
target_compile_definitions(asterism_oracle PRIVATE CGAL_NDEBUG)
# Fast enough, in debug builds too, and half the compile time of -O3.
target_compile_options(asterism_oracle PRIVATE -O1)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms in CGAL's reference counting and curve analysis, inlined into our functions.
  # The third is for clang-tidy, which reads these commands and knows not all of gcc's options.
  target_compile_options(asterism_oracle PRIVATE -Wno-use-after-free -Wno-maybe-uninitialized
                                                 -Wno-unknown-warning-option)
endif()

asterism_predicates_test(oracle_test SOURCES oracle/oracle_test.cpp LINK asterism_oracle CGAL::CGAL gmp mpfr)
target_compile_definitions(oracle_test PRIVATE CGAL_NDEBUG)

asterism_predicates_test(property_test
  SOURCES property/pointwise_test.cpp property/counts_test.cpp property/insertion_test.cpp
          property/ties_test.cpp property/counters_test.cpp
          adversarial/known_cases_test.cpp adversarial/ranges_test.cpp
  LINK asterism_oracle)
if(ASTERISM_SELF_CHECK)
  target_compile_definitions(property_test PRIVATE ASTERISM_SHARE_OF_CASES=20)
endif()

# Evaluates formulas itself, so it links what their headers include.
asterism_predicates_test(laws_test
  SOURCES property/laws_test.cpp property/laws_pointwise_test.cpp property/laws_arc_test.cpp
  LINK asterism_oracle CGAL::CGAL gmp)
target_compile_options(laws_test PRIVATE -frounding-math)
