// SPDX-License-Identifier: MIT
#include "asterism/mesh/pieces/pvtu.hpp"

#include <fmt/format.h>

namespace asterism::internal {

std::string pvtu_text(const std::vector<std::string>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "<PUnstructuredGrid GhostLevel=\"0\">\n"
      "<PPoints>\n"
      "<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
      "</PPoints>\n"
      "<PPointData Tensors=\"metric_tensor\">\n"
      "<PDataArray type=\"Float64\" Name=\"metric\" NumberOfComponents=\"3\"/>\n"
      "<PDataArray type=\"Float64\" Name=\"metric_tensor\" NumberOfComponents=\"9\"/>\n"
      "<PDataArray type=\"Int32\" Name=\"star_size\"/>\n"
      "<PDataArray type=\"Int32\" Name=\"given\"/>\n"
      "</PPointData>\n"
      "<PCellData Scalars=\"smallest_angle\">\n"
      "<PDataArray type=\"Float64\" Name=\"smallest_angle\"/>\n"
      "<PDataArray type=\"Int32\" Name=\"disagreeing\"/>\n"
      "<PDataArray type=\"Int32\" Name=\"region\"/>\n"
      "</PCellData>\n";
  for (const std::string& file : files) text += fmt::format("<Piece Source=\"{}\"/>\n", file);
  return text + "</PUnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace asterism::internal
