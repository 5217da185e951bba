# The mesher and the auditor in several threads.
find_package(Threads REQUIRED)
asterism_test(test_threads SOURCES mesh/threads_test.cpp LINK tbb Threads::Threads)
if(ASTERISM_SANITIZE MATCHES "thread")
  add_executable(planted_race mesh/planted_race.cpp)
  asterism_configure(planted_race)
  target_link_libraries(planted_race PRIVATE asterism)
  add_test(NAME "abuse: the thread sanitizer sees a race between turns of a loop"
           COMMAND planted_race)
  set_tests_properties("abuse: the thread sanitizer sees a race between turns of a loop" PROPERTIES
    PASS_REGULAR_EXPRESSION "data race" ENVIRONMENT
    "TSAN_OPTIONS=suppressions=${CMAKE_CURRENT_SOURCE_DIR}/thread_sanitizer.supp")
endif()
