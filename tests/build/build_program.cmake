# Configures, builds and runs the program in PROJECT, in the fresh folder WORK.
#   cmake -DPROJECT=... -DWORK=... -DCOMPILER=... [-DLAUNCHER=...] [-DINSTALL_FROM=<build tree>]
#         [-DREADME=...] [-DARGUMENTS=...] -P build_program.cmake
# INSTALL_FROM: install that build tree below WORK first, move it, and let it be found there.
# README: the program is the first C++ block with a main in that file.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})

if(INSTALL_FROM)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${INSTALL_FROM} --prefix ${WORK}/first
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(RENAME ${WORK}/first ${WORK}/prefix)
  list(APPEND ARGUMENTS -DCMAKE_PREFIX_PATH=${WORK}/prefix)
endif()

if(README)
  file(READ ${README} text)
  if(NOT text MATCHES "```cpp\n([^`]*int main\\(\\)[^`]*)```")
    message(FATAL_ERROR "${README}: no C++ program found")
  endif()
  file(WRITE ${WORK}/readme.cpp "${CMAKE_MATCH_1}")
  list(APPEND ARGUMENTS -DREADME_PROGRAM=${WORK}/readme.cpp)
endif()

execute_process(COMMAND ${CMAKE_COMMAND} -S ${PROJECT} -B ${WORK}/build -G Ninja
                        -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=${COMPILER}
                        -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} ${ARGUMENTS}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target program
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${WORK}/build/program WORKING_DIRECTORY ${WORK}
                COMMAND_ERROR_IS_FATAL ANY)
