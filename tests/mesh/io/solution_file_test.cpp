// SPDX-License-Identifier: MIT
#include "asterism/mesh/io/solution_file.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/vtu_numbers.hpp"
#include "asterism/tests/mesh/fixtures/temporary_directory.hpp"
#include "asterism/tests/mesh/io/sample_mesh.hpp"

using namespace asterism;
using tests::sample_mesh;
using tests::temporary_directory;

namespace {

mesh one_triangle() {
  mesh m;
  m.sites = {{{0, 0}, {1, 0, 1}}, {{1, 0}, {1, 0, 1}}, {{0, 1}, {1, 0, 1}}};
  m.triangles = {{0, 1, 2}};
  return m;
}

std::string refusal(const std::string& name, const std::string& contents) {
  const temporary_directory folder("solution");
  const auto read = read_solution(folder.write(name, contents), one_triangle());
  REQUIRE_FALSE(read.ok());
  return read.failure().message.substr(read.failure().message.find(name));
}

const std::string header = "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n";

std::string vtu(const std::string& attributes, const std::string& arrays) {
  return "<?xml version=\"1.0\"?>\n<!-- made elsewhere -->\n<VTKFile type=\"UnstructuredGrid\" "
         "version=\"0.1\" " +
         attributes +
         ">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">\n"
         "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0 "
         "1 0 0 "
         "0 1 0\n</DataArray>\n</Points>\n<PointData>\n" +
         arrays +
         "</PointData>\n<CellData>\n<DataArray type=\"Float64\" Name=\"c\" format=\"ascii\">7\n"
         "</DataArray>\n</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

solution read(const std::string& name, const std::string& contents) {
  const temporary_directory folder("solution");
  auto found = read_solution(folder.write(name, contents), one_triangle());
  INFO((found.ok() ? "" : found.failure().message));
  REQUIRE(found.ok());
  return std::move(found).value();
}

}  // namespace

TEST_CASE("a Medit solution has any list of types") {
  const solution s = read("u.sol", header +
                                       "3\n4 1 2 3 1\n"
                                       "1 2 3 4 5 6 7\n11 12 13 14 15 16 17\n"
                                       "21 22 23 24 25 26 27\nEnd\n");
  REQUIRE(s.fields.size() == 4);
  CHECK(s.fields[1].kind == field_kind::vector);
  CHECK(s.fields[1].values == std::vector<double>{2, 3, 12, 13, 22, 23});
  CHECK(s.fields[2].values == std::vector<double>{4, 5, 6, 14, 15, 16, 24, 25, 26});
  CHECK(s.fields[3].name == "4");
  const auto all = select_values(s, {});
  REQUIRE(all.ok());
  REQUIRE(all.value().size() == 4);
  CHECK(all.value()[1].name == "2.x");
  CHECK(all.value()[2].values == std::vector<double>{3, 13, 23});
  CHECK(select_values(s, {"2.y", "1", "1"}).value().size() == 2);
  CHECK(select_values(s, {"5"}).failure().message.find("there is no field '5'") == 0);
  CHECK_FALSE(select_values(s, {"3"}).ok());
}

TEST_CASE("what is written is read back, bit for bit") {
  const solution s =
      read("u.sol", header + "3\n2 1 2\n0.1 1e-300 -3\n4 5 6\n7 8 9.000000000000002\n");
  const solution again = read("v.sol", medit_fields_text(s));
  CHECK(again.fields[0].values == s.fields[0].values);
  CHECK(again.fields[1].values == s.fields[1].values);
  const solution flat = read("v.bb", bamg_fields_text(s));
  REQUIRE(flat.fields.size() == 3);
  CHECK(flat.fields[2].values == std::vector<double>{-3, 6, 9.000000000000002});
}

TEST_CASE("BAMG's solutions, with types and without") {
  CHECK(read("u.bb", "2 1 3 2\n1\n2\n3\n").fields[0].values == std::vector<double>{1, 2, 3});
  const solution typed = read("u.BB", "2 2 1 2 3 2\n1 2 3 4 5 6 7 8 9\n");
  REQUIRE(typed.fields.size() == 2);
  CHECK(typed.fields[1].values == std::vector<double>{2, 3, 5, 6, 8, 9});
}

TEST_CASE("spoiled solutions are refused with file, line and vertex") {
  CHECK(refusal("u.sol", header + "3\n1 1\n1\nnan\n3\n").find("u.sol:7: field 1, vertex 2: ") == 0);
  CHECK(refusal("u.sol", header + "3\n1 1\n1\n1e999\n3\n").find("u.sol:7: field 1, vertex 2") == 0);
  CHECK(refusal("u.sol", header + "4\n1 1\n1\n2\n3\n4\n") ==
        "u.sol:4: values at 4 vertices, and the mesh has 3");
  CHECK(refusal("u.sol", header + "3\n1 1\n1\n2\n").find("field 1, vertex 3: the file ends") !=
        std::string::npos);
  CHECK(refusal("u.sol", header + "3\n1 1\n1\n2\n3\n4\nEnd\n") ==
        "u.sol:9: '4' after the last value");
  CHECK(refusal("u.sol", header + "3\n1 4\n1\n2\n3\n").find("u.sol:5: type of a field") == 0);
  CHECK(refusal("u.sol", header + "3\n1 3\n1 0 1\n1 0 1\n1 0 1\nEnd\n").find("is a metric") !=
        std::string::npos);
  CHECK(refusal("u.sol", header + "3\n99999999999 1\n1\n").find("more than the rest") !=
        std::string::npos);
  CHECK(refusal("u.sol", "").find("the file is empty") != std::string::npos);
  CHECK(refusal("u.bb", "2 1 3 1\n1 2 3\n").find("place of the values") != std::string::npos);
  CHECK(refusal("u.bb", "3 1 3 2\n1 2 3\n").find("u.bb:1: dimension") == 0);
  CHECK(refusal("u.txt", "1").find("a solution is a file") != std::string::npos);
}

TEST_CASE("point data of a .vtu, as text and as base64") {
  const solution s =
      read("u.vtu",
           vtu("byte_order=\"LittleEndian\"",
               "<DataArray type=\"Float64\" Name=\"p\" format=\"ascii\">\n1 2\n3\n</DataArray>\n"
               "<DataArray type=\"Float32\" Name=\"v\" NumberOfComponents=\"3\" format=\"ascii\">\n"
               "1 2 0 3 4 0 5 6 0</DataArray>\n"
               "<DataArray type=\"Int32\" Name=\"id\" format=\"ascii\">1 2 3</DataArray>\n"
               // The number of bytes, 24, then 1.5, -2, 0.1 as doubles.
               "<DataArray type=\"Float64\" Name=\"b\" format=\"binary\">\n"
               "GAAAAAAAAAAAAPg/AAAAAAAAAMCamZmZmZm5Pw==\n</DataArray>\n"));
  REQUIRE(s.fields.size() == 3);
  CHECK(s.fields[0].name == "p");
  CHECK(s.fields[1].values == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(s.fields[2].values == std::vector<double>{1.5, -2, 0.1});
}

TEST_CASE("compressed arrays of a .vtu are read, in blocks, and refused where they are spoiled") {
  // The doubles 1.5, -2, 0.1 in two blocks of 16 bytes, the second of 8 bytes, each compressed by
  // zlib.
  const std::string header = "AgAAABAAAAAIAAAAEQAAAA4AAAA=";
  const std::string blocks = "eJxjYACBH/YMEHAAAAy3Afh4nJs1EwR22gMAFXoEkA==";
  const auto file = [](const std::string& compressor, const std::string& content) {
    return vtu("byte_order=\"LittleEndian\" compressor=\"" + compressor + "\"",
               "<DataArray type=\"Float64\" Name=\"b\" format=\"binary\">\n" + content +
                   "\n</DataArray>\n");
  };
  const std::string zlib = "vtkZLibDataCompressor";
  CHECK(read("u.vtu", file(zlib, header + blocks)).fields[0].values ==
        std::vector<double>{1.5, -2, 0.1});
  const auto refused = [&](const std::string& content, const char* why) {
    const std::string said = refusal("u.vtu", file(zlib, content));
    INFO(said);
    CHECK(said.find("array 'b'") != std::string::npos);
    CHECK(said.find(why) != std::string::npos);
  };
  refused("", "no header");
  refused("AgAA", "no header");
  refused("AgAAABAAAAAIAAAA", "header of compressed blocks ends");
  refused(header, "compressed bytes wanted");
  refused("AwAAABAAAAAIAAAAEQAAAA4AAAA=" + blocks, "do not have 24 bytes");
  refused("AgAAAAAAAAAIAAAAEQAAAA4AAAA=" + blocks, "do not have 24 bytes");
  refused("AgAAABAAAAAIAAAA/////w4AAAA=" + blocks, "longer than the file");
  refused(header + "AAAA" + blocks.substr(4), "is damaged");
  // Headers with no blocks, with blocks of no bytes, and with so many blocks that the sum of their
  // sizes wraps around.
  refused("AAAAAAAAAAAAAAAA",
          "0 compressed blocks of 0 bytes, the last of 0, do not have 24 bytes");
  refused("AAAAAP////8AAAAA", "do not have 24 bytes");
  const std::string wide =
      "byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"" + zlib + "\"";
  CHECK(refusal("u.vtu", vtu(wide,
                             "<DataArray type=\"Float64\" Name=\"b\" format=\"binary\">"
                             "AAAAAAAAAAD//////////wAAAAAAAAAA</DataArray>\n"))
            .find("do not have 24 bytes") != std::string::npos);
  CHECK(refusal("u.vtu", file("vtkLZ4DataCompressor", header + blocks)).find("with zlib") !=
        std::string::npos);
}

TEST_CASE("spoiled .vtu files are refused with their line") {
  const auto array = [](const std::string& rest) {
    return vtu("byte_order=\"LittleEndian\"", "<DataArray type=\"Float64\" Name=\"p\" " + rest);
  };
  CHECK(refusal("u.vtu", array("format=\"ascii\">1 nan 3</DataArray>")).find("vertex 2") !=
        std::string::npos);
  CHECK(refusal("u.vtu", array("format=\"ascii\">1 2</DataArray>"))
            .find("number 3: the array ends") != std::string::npos);
  CHECK(refusal("u.vtu", array("format=\"ascii\">1 2 3 4</DataArray>")).find("after the last") !=
        std::string::npos);
  CHECK(refusal("u.vtu", array("format=\"binary\">GAAAAAAA</DataArray>")).find("bytes wanted") !=
        std::string::npos);
  CHECK(refusal("u.vtu", array("format=\"appended\" offset=\"0\"/>")).find("no appended data") !=
        std::string::npos);
  CHECK(refusal("u.vtu", "<VTKFile type=\"UnstructuredGrid\"").find("does not end") !=
        std::string::npos);
  CHECK(refusal("u.vtu", "<html></html>").find("VTKFile") != std::string::npos);
  const std::string elsewhere = vtu("", "");
  CHECK(refusal("u.vtu", std::string(elsewhere).replace(elsewhere.find("1 0 0"), 5, "2 0 0"))
            .find("point 2 is at (2, 0)") != std::string::npos);
}

TEST_CASE("arrays of a .vtu at one place are no more than the file can hold") {
  mesh m;
  for (int i = 0; i < 100; ++i) m.sites.push_back({{static_cast<double>(i), 0}, {1, 0, 1}});
  const auto file = [](int arrays) {
    std::string text =
        "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"100\">"
        "<PointData>";
    for (int i = 0; i < arrays; ++i)
      text += "<DataArray type=\"Float64\" Name=\"a\" offset=\"0\" format=\"appended\"/>";
    // The number of bytes, 800, then 800 bytes of 0.
    return text + "</PointData></Piece></UnstructuredGrid><AppendedData encoding=\"base64\">_IAMA" +
           std::string(1068, 'A') + "</AppendedData></VTKFile>";
  };
  const temporary_directory folder("solution");
  const auto one = read_solution(folder.write("one.vtu", file(1)), m);
  INFO((one.ok() ? "" : one.failure().message));
  CHECK(one.ok());
  const auto many = read_solution(folder.write("many.vtu", file(20)), m);
  REQUIRE_FALSE(many.ok());
  CHECK(many.failure().message.find("more than a file of") != std::string::npos);
}

TEST_CASE("a .vtu mesh of so many points that products with their number wrap is refused") {
  // In 64 bits, three times this number of points is 2.
  const temporary_directory folder("wrapped");
  const auto made = read_mesh(folder.write(
      "m.vtu",
      "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>\n<Piece "
      "NumberOfPoints=\"6148914691236517206\" NumberOfCells=\"0\"><Points><DataArray "
      "type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0</DataArray></Points>"
      "</Piece></UnstructuredGrid></VTKFile>"));
  REQUIRE_FALSE(made.ok());
  CHECK(made.failure().message.find("m.vtu:2: NumberOfPoints: 6148914691236517206 are more than") !=
        std::string::npos);
}

TEST_CASE("base64 stops at what is none, and goes on after padding") {
  using namespace asterism::internal;
  CHECK(decode_base64("QUJD", 10) == "ABC");
  CHECK(decode_base64("QQ==QkM=", 10) == "ABC");
  CHECK(decode_base64("QU\nJD<x", 10) == "ABC");
  CHECK(decode_base64("QUJDQUJD", 3) == "ABC");
  const auto turned = vtu_binary_numbers("AAAAEAAAAAEAAAAC////", "Int32", 1, {true, false});
  CHECK_FALSE(turned.ok());
}
