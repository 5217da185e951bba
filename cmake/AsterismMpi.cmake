# SPDX-License-Identifier: MIT

# asterism_find_mpi(): finds MPI for C++ where it is whole. FreeFEM's package brings a wrapper of the compiler whose
# headers are in another package, and find_package(MPI) ends the configuration there instead of finding nothing.
macro(asterism_find_mpi)
  find_program(ASTERISM_MPI_WRAPPER NAMES mpicxx mpic++)
  mark_as_advanced(ASTERISM_MPI_WRAPPER)
  set(mpi_compiles TRUE)  # no such wrapper: find_package searches other places too
  if(ASTERISM_MPI_WRAPPER)
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/mpi_header.cpp "#include <mpi.h>\n")
    execute_process(COMMAND ${ASTERISM_MPI_WRAPPER} -c ${CMAKE_CURRENT_BINARY_DIR}/mpi_header.cpp
                            -o ${CMAKE_CURRENT_BINARY_DIR}/mpi_header.o
                    RESULT_VARIABLE mpi_failed OUTPUT_QUIET ERROR_QUIET)
    if(mpi_failed)
      set(mpi_compiles FALSE)
    endif()
  endif()
  if(mpi_compiles)
    find_package(MPI COMPONENTS CXX QUIET)
  else()
    message(STATUS "No MPI: ${ASTERISM_MPI_WRAPPER} does not find mpi.h")
  endif()
endmacro()
