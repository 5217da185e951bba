// SPDX-License-Identifier: MIT
#include "asterism/mesh/surface_io/space_mesh_writer.hpp"

#include <algorithm>
#include <cmath>

#include "asterism/mesh/io/file_ending.hpp"
#include "asterism/mesh/io/text_lines.hpp"

namespace asterism::internal {
namespace {

void append_point(std::string& text, const space_point& p) {
  append_number(text, p.x);
  append_number(text += ' ', p.y);
  append_number(text += ' ', p.z);
}

std::uint32_t face_of(const space_mesh& m, std::size_t t) {
  return m.faces.empty() ? 1 : m.faces[t] + 1;
}

std::string obj_text(const space_mesh& m) {
  std::string text;
  append_lines(text, m.points.size(), [&](std::size_t v, std::string& to) {
    append_point(to += "v ", m.points[v]);
    to += '\n';
  });
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    const space_triangle& c = m.triangles[t];
    append_words(to += "f ", c[0] + 1, c[1] + 1, c[2] + 1);
  });
  return text;
}

std::string stl_text(const space_mesh& m) {
  std::string text = "solid asterism\n";
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    // Writes zero normals: readers compute the normal from the corners.
    to += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : m.triangles[t]) {
      append_point(to += "vertex ", m.points[v]);
      to += '\n';
    }
    to += "endloop\nendfacet\n";
  });
  return text += "endsolid asterism\n";
}

std::string ply_text(const space_mesh& m) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex ";
  append_words(text, m.points.size());
  text += "property double x\nproperty double y\nproperty double z\nelement face ";
  append_words(text, m.triangles.size());
  text += "property list uchar int vertex_indices\nend_header\n";
  append_lines(text, m.points.size(), [&](std::size_t v, std::string& to) {
    append_point(to, m.points[v]);
    to += '\n';
  });
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    append_words(to += "3 ", m.triangles[t][0], m.triangles[t][1], m.triangles[t][2]);
  });
  return text;
}

std::string medit_text(const space_mesh& m) {
  std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices\n";
  append_words(text, m.points.size());
  append_lines(text, m.points.size(), [&](std::size_t v, std::string& to) {
    append_point(to, m.points[v]);
    to += " 0\n";
  });
  text += "Triangles\n";
  append_words(text, m.triangles.size());
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    const space_triangle& c = m.triangles[t];
    append_words(to, c[0] + 1, c[1] + 1, c[2] + 1, face_of(m, t));
  });
  return text += "End\n";
}

std::string gmsh_text(const space_mesh& m) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n";
  append_words(text, m.points.size());
  append_lines(text, m.points.size(), [&](std::size_t v, std::string& to) {
    append_integer(to, v + 1);
    append_point(to += ' ', m.points[v]);
    to += '\n';
  });
  text += "$EndNodes\n$Elements\n";
  append_words(text, m.triangles.size());
  append_lines(text, m.triangles.size(), [&](std::size_t t, std::string& to) {
    const space_triangle& c = m.triangles[t];
    append_integer(to, t + 1);
    append_words(to += " 2 2 ", face_of(m, t), face_of(m, t), c[0] + 1, c[1] + 1, c[2] + 1);
  });
  return text += "$EndElements\n";
}

template <class Item>
void append_array(std::string& text, const std::string& head, std::size_t count, const Item& item) {
  text += "<DataArray ";
  text += head;
  text += " format=\"ascii\">\n";
  append_lines(text, count, item);
  text += "</DataArray>\n";
}

std::string vtu_text(const space_mesh& m) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"";
  append_integer(text, m.points.size());
  append_integer(text += "\" NumberOfCells=\"", m.triangles.size());
  text += "\">\n<Points>\n";
  append_array(text, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", m.points.size(),
               [&](std::size_t v, std::string& to) {
                 append_point(to, m.points[v]);
                 to += '\n';
               });
  text += "</Points>\n<Cells>\n";
  const std::size_t count = m.triangles.size();
  append_array(text, "type=\"Int64\" Name=\"connectivity\"", count,
               [&](std::size_t t, std::string& to) {
                 append_words(to, m.triangles[t][0], m.triangles[t][1], m.triangles[t][2]);
               });
  append_array(text, "type=\"Int64\" Name=\"offsets\"", count,
               [](std::size_t t, std::string& to) { append_words(to, 3 * t + 3); });
  append_array(text, "type=\"UInt8\" Name=\"types\"", count,
               [](std::size_t, std::string& to) { to += "5\n"; });
  text += "</Cells>\n<CellData>\n";
  append_array(text, "type=\"Int64\" Name=\"face\"", count,
               [&](std::size_t t, std::string& to) { append_words(to, face_of(m, t)); });
  return text += "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

result<std::string> space_mesh_text(const space_mesh& m, const std::string& file) {
  if (has_ending(file, ".obj")) return obj_text(m);
  if (has_ending(file, ".stl")) return stl_text(m);
  if (has_ending(file, ".ply")) return ply_text(m);
  if (has_ending(file, ".mesh")) return medit_text(m);
  if (has_ending(file, ".msh")) return gmsh_text(m);
  if (has_ending(file, ".vtu")) return vtu_text(m);
  return error{file + ": meshes in space are written as .obj, .stl, .ply, .mesh, .msh or .vtu",
               error_code::bad_option};
}

}  // namespace asterism::internal
