# The predicates in hostile surroundings, from C, from threads, under fuzzing; the examples that
# embed them. Everything here links the predicates alone.
enable_language(C)
find_package(CGAL REQUIRED)
find_package(Threads REQUIRED)
find_program(ASTERISM_CLANGXX NAMES clang++ clang++-14)
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/abuse)

add_library(asterism_abuse_inputs STATIC abuse/abuse_inputs.cpp)
asterism_configure(asterism_abuse_inputs)
target_link_libraries(asterism_abuse_inputs PUBLIC asterism_predicates)

add_executable(c_api_test abuse/c_api_test.c)
set_target_properties(c_api_test PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_compile_options(c_api_test PRIVATE -Wall -Wextra -pedantic -Werror)
target_link_libraries(c_api_test PRIVATE asterism_predicates)
add_test(NAME "abuse: the C functions from C11" COMMAND c_api_test)

asterism_predicates_test(checked_kernel_test
  SOURCES abuse/checked_kernel_test.cpp LINK asterism_abuse_inputs)
asterism_predicates_test(threads_test
  SOURCES abuse/threads_test.cpp LINK asterism_abuse_inputs Threads::Threads)

# What a difference is reported as, printed, compiled and run.
add_executable(print_tests abuse/print_tests.cpp)
asterism_configure(print_tests)
target_link_libraries(print_tests PRIVATE asterism_abuse_inputs)
set(printed_tests ${CMAKE_CURRENT_BINARY_DIR}/abuse/differences.inc)
add_custom_command(OUTPUT ${printed_tests} COMMAND print_tests ${printed_tests} VERBATIM)
add_executable(printed_tests abuse/printed_tests.cpp ${printed_tests})
asterism_configure(printed_tests)
target_include_directories(printed_tests PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/abuse)
target_link_libraries(printed_tests PRIVATE asterism_test_main asterism_predicates)
add_test(NAME "abuse: reports of differences are tests that compile and pass"
         COMMAND printed_tests)

# In the self-check build the library brings shadowed_interval.cpp itself.
asterism_predicates_test(self_check_test SOURCES abuse/self_check_test.cpp LINK CGAL::CGAL gmp)
target_compile_options(self_check_test PRIVATE -frounding-math)
if(ASTERISM_SELF_CHECK)
  add_executable(self_check_violation abuse/self_check_violation.cpp)
  asterism_configure(self_check_violation)
  target_compile_options(self_check_violation PRIVATE -frounding-math)
  target_link_libraries(self_check_violation PRIVATE asterism_predicates CGAL::CGAL gmp)
  add_test(NAME "abuse: the self-check aborts on a wrong enclosure" COMMAND self_check_violation)
  set_tests_properties("abuse: the self-check aborts on a wrong enclosure" PROPERTIES
    PASS_REGULAR_EXPRESSION "self-check: the exact result of a sum lies outside")
else()
  target_sources(self_check_test PRIVATE ${PROJECT_SOURCE_DIR}/core/shadowed_interval.cpp)
endif()

# Callers: one object file for each compiler and set of options, whatever this build's own are.
set(callers)
set(caller_objects)
function(asterism_abuse_caller compiler options)
  string(MAKE_C_IDENTIFIER "caller_${compiler} ${options}" function)
  set(object ${CMAKE_CURRENT_BINARY_DIR}/abuse/${function}.o)
  separate_arguments(option_list UNIX_COMMAND "${options}")
  add_custom_command(OUTPUT ${object}
    COMMAND ${${compiler}_path} -std=c++20 ${option_list} -DASTERISM_CALLER=${function}
            -I${PROJECT_BINARY_DIR}/include -MD -MF ${object}.d
            -c ${CMAKE_CURRENT_SOURCE_DIR}/abuse/abuse_caller.cpp -o ${object}
    DEPENDS abuse/abuse_caller.cpp DEPFILE ${object}.d VERBATIM)
  set(callers "${callers}ASTERISM_CALLER_ENTRY(${function}, \"${compiler} ${options}\")\n"
      PARENT_SCOPE)
  set(caller_objects ${caller_objects} ${object} PARENT_SCOPE)
endfunction()
set(native "-march=native")
if(CMAKE_CROSSCOMPILING)
  set(native "")
endif()
find_program(ASTERISM_GXX NAMES g++)
foreach(compiler IN ITEMS GXX CLANGXX)
  if(ASTERISM_${compiler})
    set(${compiler}_path ${ASTERISM_${compiler}})
    foreach(options IN ITEMS "-O0" "-O2" "-O3 ${native}" "-O2 -ffast-math")
      asterism_abuse_caller(${compiler} "${options}")
    endforeach()
  endif()
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/abuse/abuse_callers.inc CONTENT "${callers}" @ONLY)

add_executable(abuse_matrix
  abuse/abuse_matrix.cpp abuse/caller_environment.cpp fuzz/parts_as_kernels.cpp ${caller_objects})
asterism_configure(abuse_matrix)
target_include_directories(abuse_matrix PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/abuse)
target_link_libraries(abuse_matrix PRIVATE asterism_abuse_inputs)
add_test(NAME "abuse: matrix, modest" COMMAND abuse_matrix 1)

set(compilers ${ASTERISM_GXX} ${ASTERISM_CLANGXX})
list(FILTER compilers EXCLUDE REGEX "NOTFOUND")
add_test(NAME "abuse: fast-math is refused where it would be wrong"
         COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/abuse/fast_math.py
                 ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include ${compilers})

# The committed corpus without a fuzzer; and a minute with one, where clang brings it.
add_executable(replay_corpus
  fuzz/replay_corpus.cpp fuzz/fuzz_predicates.cpp fuzz/decode_record.cpp fuzz/parts_as_kernels.cpp)
asterism_configure(replay_corpus)
target_link_libraries(replay_corpus PRIVATE asterism_predicates)
add_test(NAME "fuzz: the corpus again"
         COMMAND replay_corpus ${CMAKE_CURRENT_SOURCE_DIR}/fuzz/corpus)
if(ASTERISM_CLANGXX AND NOT ASTERISM_SANITIZE)
  execute_process(COMMAND ${ASTERISM_CLANGXX} -print-file-name=libclang_rt.fuzzer-x86_64.a
                  OUTPUT_VARIABLE fuzzer OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${ASTERISM_CLANGXX} -print-runtime-dir
                  OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(EXISTS "${fuzzer}" OR EXISTS "${runtime}/libclang_rt.fuzzer-x86_64.a")
    add_test(NAME "fuzz: one minute"
             COMMAND ${PROJECT_SOURCE_DIR}/scripts/fuzz 60 ${PROJECT_BINARY_DIR}/fuzz)
    set_tests_properties("fuzz: one minute" PROPERTIES LABELS fuzz TIMEOUT 900
      ENVIRONMENT "ASTERISM_FUZZ_OPTIONS=-DASTERISM_SELF_CHECK=${ASTERISM_SELF_CHECK}")
  endif()
endif()

# The examples that embed the predicates.
add_executable(example_foreign_mesher
  ${PROJECT_SOURCE_DIR}/examples/foreign_mesher/foreign_mesher.cpp)
asterism_configure(example_foreign_mesher)
target_link_libraries(example_foreign_mesher PRIVATE asterism_predicates)
add_test(NAME "examples: foreign_mesher" COMMAND example_foreign_mesher)
if(TARGET asterism_command)
  set(suite ${PROJECT_SOURCE_DIR}/examples/adversarial_suite)
  foreach(pair IN ITEMS "filtered;exact;0" "interval;exact;0" "double;exact;some")
    list(GET pair 0 kernel)
    add_test(NAME "examples: adversarial_suite, ${kernel}"
             COMMAND ${Python3_EXECUTABLE} ${suite}/compare_kernels.py
                     $<TARGET_FILE:asterism_command> ${suite}/records.txt ${pair})
  endforeach()
endif()
