# The mesher for WebAssembly (packages/npm): one thread, no files, no pictures. Libraries that are
# headers are found where scripts/build-npm has put them.
target_compile_definitions(asterism PRIVATE ASTERISM_ONE_THREAD FMT_HEADER_ONLY)
target_include_directories(asterism SYSTEM PRIVATE ${Boost_INCLUDE_DIR})
list(REMOVE_ITEM folders transfer surface_audit proof draw surface_io surface pieces)
foreach(folder IN LISTS folders)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/mesh/${folder}/*.cpp)
  target_sources(asterism PRIVATE ${sources})
endforeach()
get_target_property(sources asterism SOURCES)
# JavaScript hands over files as texts.
list(FILTER sources EXCLUDE REGEX "/io/text_scanner_files")
# Leaves out pictures, and files of VTK's XML, which need zlib.
list(FILTER sources EXCLUDE REGEX "/io/(write_mesh|vtu|vtu_[a-z]+)\\.cpp")
list(APPEND sources ${PROJECT_SOURCE_DIR}/packages/npm/asterism-mesh/no_vtu.cpp
                    ${PROJECT_SOURCE_DIR}/packages/npm/asterism-mesh/given_files.cpp
                    ${PROJECT_SOURCE_DIR}/packages/npm/standard_library.cpp)
set_target_properties(asterism PROPERTIES SOURCES "${sources}")
