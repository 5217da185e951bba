# The build itself, and the command as a user runs it.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# Every header compiles alone: one translation unit each, which includes it twice.
set(folders core predicates kernels mesh apps)
set(header_sources)
foreach(folder IN LISTS folders)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
       ${PROJECT_SOURCE_DIR}/${folder}/*.hpp)
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

add_test(NAME "build: layers are one way"
         COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/build/check_layering.py
                 ${PROJECT_SOURCE_DIR})
add_test(NAME "build: licences"
         COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/build/check_licenses.py
                 ${PROJECT_SOURCE_DIR})
