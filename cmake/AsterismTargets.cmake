# asterism_configure(TARGET): the language level, warnings and floating-point rules of every target.
function(asterism_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Ignores CMAKE_UNITY_BUILD of a host, which would join files that asterism_unite keeps apart.
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF UNITY_BUILD OFF)
  # Contraction would change the value of a*b+c. The filters' error bounds assume two roundings.
  # No function of the C library that may set errno takes the place of a square root, and none of their errors is read.
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno)
  if(EMSCRIPTEN)  # targets whose standard library lacks some functions
    target_compile_options(${target} PRIVATE
      -include ${PROJECT_SOURCE_DIR}/packages/npm/standard_library.hpp)
    if(ASTERISM_BUILD_MESHER)  # targets that catch exceptions of other libraries
      target_compile_options(${target} PRIVATE -fwasm-exceptions)
      target_link_options(${target} PRIVATE -fwasm-exceptions)
    endif()
  endif()
  if(ASTERISM_WARNINGS_ARE_ERRORS)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion
                                             -Wno-sign-conversion -Werror)
  endif()
  if(ASTERISM_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${ASTERISM_SANITIZE}
                                            -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${ASTERISM_SANITIZE})
  endif()
endfunction()

# asterism_hide(TARGET): compiles objects for a shared library that exports only what
# ASTERISM_EXPORT marks. Its functions are not replaced at load time, so they may be inlined.
function(asterism_hide target)
  set_target_properties(${target} PROPERTIES
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(EMSCRIPTEN)  # WebAssembly: a module is linked once, and position-independent code would take time
    return()
  endif()
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
endfunction()

# asterism_unite(TARGET [ALONE SOURCE...] [TOGETHER FOLDER+FOLDER...]): under ASTERISM_UNITY each folder of the target's
# sources is compiled as one file, which reads every header once, and the folders that TOGETHER names as one: for those
# whose time is mostly that of headers (docs/results/front_door.md). So two files of them may not give one name to
# different things, in unnamed namespaces either (tests/build/check_united.py). Editing one file then compiles all of
# them anew: for building once, not for working on it.
function(asterism_unite target)
  if(NOT ASTERISM_UNITY)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "ALONE;TOGETHER" ${ARGN})
  get_target_property(sources ${target} SOURCES)
  list(REMOVE_ITEM sources ${arg_ALONE})
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(folder "${folder}" NAME)
    set(group "${folder}")
    foreach(joined IN LISTS arg_TOGETHER)
      string(REPLACE "+" ";" folders ${joined})
      if(folder IN_LIST folders)
        string(REPLACE "+" "_" group ${joined})
      endif()
    endforeach()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${target}_${group}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Allows names inside functions of one file that are constants of another.
  target_compile_options(${target} PRIVATE -Wno-shadow)
endfunction()

# asterism_compile_cheaply(TARGET): under ASTERISM_UNITY with -O1, which takes three fifths of the time of -O3. For what
# reads options and writes summaries, in which nothing is repeated as often as there are triangles, and for programs of
# tests, whose time is the library's.
function(asterism_compile_cheaply target)
  if(ASTERISM_UNITY AND NOT EMSCRIPTEN)
    target_compile_options(${target} PRIVATE -O1)
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      # GCC 12 at -O1 takes the copy of a moved string for one beyond its end.
      target_compile_options(${target} PRIVATE -Wno-array-bounds)
    endif()
  endif()
endfunction()

# asterism_read_once(TARGET HEADER...): under ASTERISM_UNITY the headers are read once for all files of the target.
function(asterism_read_once target)
  if(ASTERISM_UNITY AND NOT EMSCRIPTEN)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# asterism_read_as(TARGET OTHER): under ASTERISM_UNITY what is read once for OTHER is not read for TARGET either. Their
# options of compilation have to be the same, and no header among them may know a definition that only one has.
function(asterism_read_as target other)
  if(ASTERISM_UNITY AND NOT EMSCRIPTEN)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()

# asterism_join(VARIABLE NAME SOURCE...): the same for sources that have options of their own, which CMake leaves out of
# such files: without ASTERISM_UNITY the sources as they are, with it a file NAME.cpp that includes them.
function(asterism_join variable name)
  set(sources ${ARGN})
  if(ASTERISM_UNITY)
    set(joined_includes "")
    foreach(source IN LISTS sources)
      get_filename_component(source ${source} ABSOLUTE)
      string(APPEND joined_includes "#include \"${source}\"\n")
    endforeach()
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/joined/${name}.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/joined.cpp.in ${sources} @ONLY)
  endif()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# asterism_compile_folders_cheaply(TARGET FOLDER...): under ASTERISM_UNITY the target's sources of each folder named here
# become one file that is compiled with -O1. For readers and writers, whose time is that of files and of the numbers in
# them (docs/results/front_door.md). To be called before asterism_unite, when the sources are known.
function(asterism_compile_folders_cheaply target)
  if(NOT ASTERISM_UNITY OR EMSCRIPTEN)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(folder IN LISTS ARGN)
    set(of_folder ${sources})
    list(FILTER of_folder INCLUDE REGEX "/${folder}/[^/]*$")
    list(REMOVE_ITEM sources ${of_folder})
    asterism_join(joined ${folder} ${of_folder})
    set_source_files_properties(${joined} PROPERTIES COMPILE_OPTIONS -O1)
    list(APPEND sources ${joined})
  endforeach()
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
endfunction()

# asterism_use_threads(TARGET): threads of the system; without ASTERISM_THREADS the caller's thread does all.
function(asterism_use_threads target)
  if(ASTERISM_THREADS)
    set(THREADS_PREFER_PTHREAD_FLAG ON)
    find_package(Threads REQUIRED)
    target_link_libraries(${target} PRIVATE Threads::Threads)
  else()
    target_compile_definitions(${target} PRIVATE ASTERISM_ONE_THREAD)
  endif()
endfunction()

# asterism_contain_libraries(TARGET): links the archives of GMP, MPFR, zlib and the C++ library into a program, and
# compiles into it what fmt has in a library. It then loads six libraries less, binds fewer names, and calls their
# functions without a table. Packages of a distribution, which replaces libraries by themselves, leave it out.
function(asterism_contain_libraries target)
  if(NOT ASTERISM_CONTAIN_LIBRARIES)
    return()
  endif()
  asterism_contain_archives(${target})
  # The libraries of sanitizers bind the names of the C++ library.
  if(NOT ASTERISM_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    asterism_contain_cxx(${target})
  endif()
endfunction()

# The linker searches a folder with the archives of GMP and MPFR first, so that what the static libraries export stays
# as it is; by an option, since CMake lets a program search a folder of libraries for those that it loads, too.
function(asterism_contain_archives target)
  find_library(ASTERISM_ZLIB_ARCHIVE libz.a)
  if(ASTERISM_ZLIB_ARCHIVE)
    asterism_try_archives(ASTERISM_ZLIB_LINKS "#include <zlib.h>
      int main() { return compressBound(1) != 0 ? 0 : 1; }" ${ASTERISM_ZLIB_ARCHIVE})
    if(ASTERISM_ZLIB_LINKS)  # behind the library that calls it; nothing is then left to find in its own zlib
      target_link_libraries(${target} PRIVATE asterism ${ASTERISM_ZLIB_ARCHIVE})
    endif()
  endif()
  if(NOT ASTERISM_EXACT STREQUAL "gmp")
    return()
  endif()
  find_library(ASTERISM_MPFR_ARCHIVE libmpfr.a)
  find_library(ASTERISM_GMP_ARCHIVE libgmp.a)
  if(NOT ASTERISM_MPFR_ARCHIVE OR NOT ASTERISM_GMP_ARCHIVE)
    return()
  endif()
  asterism_try_archives(ASTERISM_ARCHIVES_LINK "#include <mpfr.h>
    int main() { mpfr_t x; mpfr_init_set_ui(x, 1, MPFR_RNDN); return mpfr_sgn(x) - 1; }"
    ${ASTERISM_MPFR_ARCHIVE} ${ASTERISM_GMP_ARCHIVE})
  if(ASTERISM_ARCHIVES_LINK)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/archives)
    file(CREATE_LINK ${ASTERISM_MPFR_ARCHIVE} ${PROJECT_BINARY_DIR}/archives/libmpfr.a SYMBOLIC)
    file(CREATE_LINK ${ASTERISM_GMP_ARCHIVE} ${PROJECT_BINARY_DIR}/archives/libgmp.a SYMBOLIC)
    target_link_options(${target} BEFORE PRIVATE -L${PROJECT_BINARY_DIR}/archives)
  endif()
endfunction()

# Tries a program with archives. Those without position-independent code cannot be linked into the usual programs.
function(asterism_try_archives links program)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_LIBRARIES ${ARGN})
  check_cxx_source_compiles("${program}" ${links})
endfunction()

# The archive of the C++ library is of use only where no other library loads that library: fmt does, so that both are
# contained or none. The functions of fmt are tried with the fmt that there is, whose versions differ in them.
function(asterism_contain_cxx target)
  set(options -static-libstdc++ -static-libgcc -Wl,--as-needed)
  if(NOT DEFINED ASTERISM_FMT_COMPILES)
    file(WRITE ${PROJECT_BINARY_DIR}/contained/main.cpp "#include <fmt/format.h>
      int main() { return fmt::format(\"{} {:.3f} {:L}\", 0.1, 0.1f, 1).empty() ? 1 : 0; }")
    get_target_property(folder fmt::fmt INTERFACE_INCLUDE_DIRECTORIES)
    try_compile(ASTERISM_FMT_COMPILES ${PROJECT_BINARY_DIR}/contained
      SOURCES ${PROJECT_BINARY_DIR}/contained/main.cpp ${PROJECT_SOURCE_DIR}/apps/base/fmt_library.cpp
      CMAKE_FLAGS "-DINCLUDE_DIRECTORIES=${folder}" LINK_OPTIONS ${options} CXX_STANDARD 20)
  endif()
  if(ASTERISM_FMT_COMPILES)
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/apps/base/fmt_library.cpp)
    target_link_options(${target} PRIVATE ${options})
  endif()
endfunction()
