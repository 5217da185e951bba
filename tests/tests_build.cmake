# The build itself, and the command as a user runs it.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# Every header compiles alone: one translation unit each, which includes it twice.
set(folders core predicates kernels mesh apps)
set(header_sources)
foreach(folder IN LISTS folders)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
       ${PROJECT_SOURCE_DIR}/${folder}/*.hpp ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  foreach(header IN LISTS headers)
    string(REPLACE "/" "_" unit ${header})
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/headers/${unit}.cpp)
    set(line "#include \"asterism/${header}\"  // IWYU pragma: keep\n")
    file(CONFIGURE OUTPUT ${unit} CONTENT "${line}${line}" @ONLY)
    list(APPEND header_sources ${unit})
  endforeach()
endforeach()
find_package(CLI11 REQUIRED)
add_library(headers_compile_alone OBJECT ${header_sources})
asterism_configure(headers_compile_alone)
target_compile_options(headers_compile_alone PRIVATE -O0)
target_link_libraries(headers_compile_alone PRIVATE asterism CLI11::CLI11)

foreach(check layering licenses documents)
  add_test(NAME "build: check_${check}"
           COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/build/check_${check}.py
                   ${PROJECT_SOURCE_DIR})
endforeach()

# What others build with the library: installed and moved elsewhere, or as a subdirectory.
function(asterism_program_test name project)
  string(MAKE_C_IDENTIFIER ${name} folder)
  add_test(NAME "build: ${name}"
           COMMAND ${CMAKE_COMMAND} -DPROJECT=${CMAKE_CURRENT_SOURCE_DIR}/build/${project}
                   -DWORK=${CMAKE_CURRENT_BINARY_DIR}/programs/${folder}
                   -DCOMPILER=${CMAKE_CXX_COMPILER} -DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER} ${ARGN}
                   -P ${CMAKE_CURRENT_SOURCE_DIR}/build/build_program.cmake)
endfunction()
asterism_program_test("program of the README, installed" readme_program
                      -DINSTALL_FROM=${PROJECT_BINARY_DIR} -DREADME=${PROJECT_SOURCE_DIR}/README.md)
asterism_program_test("predicates alone, installed" predicates_only
                      -DINSTALL_FROM=${PROJECT_BINARY_DIR})
asterism_program_test("predicates alone, subdirectory" predicates_only
                      -DARGUMENTS=-DASTERISM_SOURCE=${PROJECT_SOURCE_DIR})

asterism_test(test_parse_number SOURCES apps/parse_number_test.cpp)

# The tutorial's programs.
foreach(example first_question first_mesh)
  add_executable(example_${example} ${PROJECT_SOURCE_DIR}/examples/${example}.cpp)
  asterism_configure(example_${example})
  target_link_libraries(example_${example} PRIVATE asterism)
  add_test(NAME "examples: ${example}" COMMAND example_${example})
endforeach()

# The command through its arguments, files and exit statuses: one Python program a subject.
if(TARGET asterism_command)
  foreach(subject eval_command bad_input mesh_command certify_command domains)
    add_test(NAME "apps: ${subject}"
             COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/apps/${subject}.py)
    set_tests_properties("apps: ${subject}" PROPERTIES
      ENVIRONMENT "ASTERISM_COMMAND=$<TARGET_FILE:asterism_command>;PYTHONDONTWRITEBYTECODE=1")
  endforeach()
endif()
