target_sources(asterism PRIVATE
  local/box_index.cpp
  local/hilbert_order.cpp
  local/neighbourhood.cpp
  local/site_index.cpp
  fill/domain_locator.cpp
  fill/fill.cpp
  fill/plain_net.cpp
  fill/scattered_places.cpp
  fill/segment_division.cpp)
find_package(TBB REQUIRED)
target_link_libraries(asterism PUBLIC TBB::tbb)
