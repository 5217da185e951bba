// SPDX-License-Identifier: MIT
//
// asterism-occt IN.step|IN.stp|IN.brep|IN.brp OUT.json
//
// Writes the faces of a CAD file as B-spline patches with loops, as `asterism surface` reads them.
// OpenCASCADE reads the file and makes B-splines of its surfaces and curves; what is meshed and
// certified is what stands in the JSON, in doubles.
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dConvert.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Precision.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using json = nlohmann::ordered_json;

constexpr int most_degree = 12;  // the greatest degree that Asterism reads

struct refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Writes a number with the digits that determine it.
std::string text_of(double x) { return json(x).dump(); }

bool ends_with(std::string name, const std::string& ending) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

TopoDS_Shape read_shape(const std::string& file) {
  if (!std::ifstream(file)) throw refusal(file + ": no such file, or it cannot be read");
  TopoDS_Shape shape;
  if (ends_with(file, ".step") || ends_with(file, ".stp")) {
    STEPControl_Reader reader;
    if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
      throw refusal(file + ": this is no STEP file");
    reader.TransferRoots();
    shape = reader.OneShape();
  } else if (ends_with(file, ".brep") || ends_with(file, ".brp")) {
    if (!BRepTools::Read(shape, file.c_str(), BRep_Builder()))
      throw refusal(file + ": this is no BREP file");
  } else {
    throw refusal(file + ": .step, .stp, .brep or .brp is wanted");
  }
  if (shape.IsNull() || !TopExp_Explorer(shape, TopAbs_FACE).More())
    throw refusal(file + ": there is no face in it");
  return shape;
}

// Holds a face with everything needed for its output.
struct face_reader {
  TopoDS_Face face;  // forward: its loops have the face on their left in (u, v)
  std::string name;
  bool swapped = false;  // u and v change places, for a face seen from the other side
  const TopTools_IndexedDataMapOfShapeListOfShape& edges;  // edges with the faces that they bound
  std::vector<std::string>& notes;

  json patch();
  opencascade::handle<Geom_BSplineSurface> surface() const;
  json surface_members(const Geom_BSplineSurface& s);
  json loop(const TopoDS_Wire& wire) const;
  json curve(const TopoDS_Edge& edge) const;
  bool is_alone() const;
  double off_sides(const json& loops, const Geom_BSplineSurface& s) const;
  void make_poles_points(std::vector<std::vector<gp_Pnt>>& rows);
};

// Returns the knots shifted by the multiple of the period with which the first is next to `start`.
TColStd_Array1OfReal beginning_at(TColStd_Array1OfReal knots, double start, double period) {
  const double off = period * std::round((knots.First() - start) / period);
  for (double& k : knots) k -= off;
  return knots;
}

// Cuts a periodic surface where the face begins, so that its knots are those around the face's
// curves. OpenCASCADE cuts in the first period. A face that begins at 0 up to rounding, or left of
// 0, is in another period than its curves.
void cut_period(Geom_BSplineSurface& s, const TopoDS_Face& face) {
  double a = 0, b = 0, c = 0, d = 0, u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  const bool in_u = s.IsUPeriodic(), in_v = s.IsVPeriodic();
  s.Bounds(a, b, c, d);
  BRepTools::UVBounds(face, u0, u1, v0, v1);
  if (!in_u) u0 = a, u1 = b;
  if (!in_v) v0 = c, v1 = d;
  u1 = std::min(u1, u0 + (b - a)), v1 = std::min(v1, v0 + (d - c));
  s.Segment(u0, u1, v0, v1);
  if (s.IsUPeriodic()) s.SetUNotPeriodic();
  if (s.IsVPeriodic()) s.SetVNotPeriodic();
  if (in_u) s.SetUKnots(beginning_at(s.UKnots(), u0, b - a));
  if (in_v) s.SetVKnots(beginning_at(s.VKnots(), v0, d - c));
}

opencascade::handle<Geom_BSplineSurface> face_reader::surface() const {
  opencascade::handle<Geom_Surface> any = BRep_Tool::Surface(face);
  if (const auto trimmed = opencascade::handle<Geom_RectangularTrimmedSurface>::DownCast(any);
      !trimmed.IsNull())
    any = trimmed->BasisSurface();
  auto s = opencascade::handle<Geom_BSplineSurface>::DownCast(any);
  if (s.IsNull()) s = GeomConvert::SurfaceToBSplineSurface(any);
  if (s.IsNull()) throw refusal(name + ": its surface cannot be made a B-spline");
  s = opencascade::handle<Geom_BSplineSurface>::DownCast(s->Copy());
  if (s->IsUPeriodic() || s->IsVPeriodic()) cut_period(*s, face);
  if (s->UDegree() > most_degree || s->VDegree() > most_degree)
    throw refusal(name + ": its surface has degree " +
                  std::to_string(std::max(s->UDegree(), s->VDegree())) + ", and " +
                  std::to_string(most_degree) + " is the greatest that asterism treats");
  return s;
}

// Makes the points of a side equal if they differ by rounding only: what is proved at a pole is
// proved of one point. A note says how far the surface was moved.
void face_reader::make_poles_points(std::vector<std::vector<gp_Pnt>>& rows) {
  // In units of length: OpenCASCADE itself identifies points that are nearer.
  const double tolerance = std::min(BRep_Tool::Tolerance(face), Precision::Confusion());
  const auto settle = [&](const std::vector<gp_Pnt*>& side) {
    double far = 0;
    for (const gp_Pnt* p : side) far = std::max(far, p->Distance(*side[0]));
    if (far == 0 || far > tolerance) return;
    for (gp_Pnt* p : side) *p = *side[0];
    notes.push_back(name + ": a side at the end of a parameter is one point but for " +
                    text_of(far) + ", and became one");
  };
  for (auto* row : {&rows.front(), &rows.back()}) {
    std::vector<gp_Pnt*> side;
    for (gp_Pnt& p : *row) side.push_back(&p);
    settle(side);
  }
  for (const bool last : {false, true}) {
    std::vector<gp_Pnt*> side;
    for (auto& row : rows) side.push_back(last ? &row.back() : &row.front());
    settle(side);
  }
}

json face_reader::surface_members(const Geom_BSplineSurface& s) {
  std::vector<std::vector<gp_Pnt>> points(static_cast<std::size_t>(s.NbUPoles()));
  std::vector<std::vector<double>> weights(points.size());
  for (int i = 1; i <= s.NbUPoles(); ++i)
    for (int j = 1; j <= s.NbVPoles(); ++j) {
      points[static_cast<std::size_t>(i - 1)].push_back(s.Pole(i, j));
      weights[static_cast<std::size_t>(i - 1)].push_back(s.Weight(i, j));
    }
  make_poles_points(points);
  const std::size_t rows = swapped ? points[0].size() : points.size(),
                    columns = swapped ? points.size() : points[0].size();
  json control = json::array(), all_weights = json::array();
  for (std::size_t i = 0; i < rows; ++i) {
    json row = json::array(), weight_row = json::array();
    for (std::size_t j = 0; j < columns; ++j) {
      const gp_Pnt& p = swapped ? points[j][i] : points[i][j];
      row.push_back({p.X(), p.Y(), p.Z()});
      weight_row.push_back(swapped ? weights[j][i] : weights[i][j]);
    }
    control.push_back(row), all_weights.push_back(weight_row);
  }
  const auto list = [](const TColStd_Array1OfReal& from) {
    return json(std::vector<double>(from.begin(), from.end()));
  };
  json u = list(s.UKnotSequence()), v = list(s.VKnotSequence());
  if (swapped) std::swap(u, v);
  json members = {
      {"name", name},
      {"degree", swapped ? json{s.VDegree(), s.UDegree()} : json{s.UDegree(), s.VDegree()}},
      {"knots_u", u},
      {"knots_v", v},
      {"control", control}};
  if (s.IsURational() || s.IsVRational()) members["weights"] = all_weights;
  return members;
}

json face_reader::curve(const TopoDS_Edge& edge) const {
  double first = 0, last = 0;
  const auto any = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const int number = edges.FindIndex(edge);
  const std::string where = name + ": edge " + std::to_string(number);
  if (any.IsNull()) throw refusal(where + " has no curve on the surface");
  auto c = Geom2dConvert::CurveToBSplineCurve(new Geom2d_TrimmedCurve(any, first, last));
  if (c->IsPeriodic()) c->SetNotPeriodic();
  if (c->Degree() > most_degree)
    throw refusal(where + " has a curve of degree " + std::to_string(c->Degree()) + ", and " +
                  std::to_string(most_degree) + " is the greatest that asterism treats");
  // Reverses the curves of reversed edges; of a face that is seen from behind, all others.
  const bool backward = (edge.Orientation() == TopAbs_REVERSED) != swapped;
  if (backward) c->Reverse();
  json control = json::array(), weights = json::array();
  for (int k = 1; k <= c->NbPoles(); ++k) {
    const gp_Pnt2d p = c->Pole(k);
    control.push_back(swapped ? json{p.Y(), p.X()} : json{p.X(), p.Y()});
    weights.push_back(c->Weight(k));
  }
  const TColStd_Array1OfReal& knots = c->KnotSequence();
  json members = {{"degree", c->Degree()},
                  {"edge", "e" + std::to_string(number)},
                  {"knots", std::vector<double>(knots.begin(), knots.end())},
                  {"control", control}};
  if (c->IsRational()) members["weights"] = weights;
  if (backward) members["backward"] = true;
  if (BRep_Tool::Degenerated(edge)) members["point"] = true;
  return members;
}

json face_reader::loop(const TopoDS_Wire& wire) const {
  std::vector<json> curves;
  for (BRepTools_WireExplorer at(wire, face); at.More(); at.Next())
    curves.push_back(curve(at.Current()));
  int edges_of_wire = 0;
  for (TopExp_Explorer at(wire, TopAbs_EDGE); at.More(); at.Next()) ++edges_of_wire;
  if (edges_of_wire != static_cast<int>(curves.size()))
    throw refusal(name + ": the edges of a wire are no closed chain");
  if (swapped) std::reverse(curves.begin(), curves.end());
  return curves;
}

// True if no other face has an edge of this one.
bool face_reader::is_alone() const {
  for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next())
    for (const TopoDS_Shape& other : edges.FindFromKey(at.Current()))
      if (!other.IsSame(face)) return false;
  return true;
}

// Returns the distance of the curves from the nearest sides of the patch, as a part of a
// parameter's range.
double face_reader::off_sides(const json& loops, const Geom_BSplineSurface& s) const {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  s.Bounds(u0, u1, v0, v1);
  if (swapped) std::swap(u0, v0), std::swap(u1, v1);
  struct side {
    std::size_t parameter;
    double at, range;
  };
  const std::array<side, 4> sides = {
      side{0, u0, u1 - u0}, {0, u1, u1 - u0}, {1, v0, v1 - v0}, {1, v1, v1 - v0}};
  const auto off_side = [](const json& curve, const side& from) {
    double most = 0;
    for (const json& point : curve["control"])
      most = std::max(most, std::abs(point[from.parameter].get<double>() - from.at) / from.range);
    return most;
  };
  double most = 0;
  for (const json& loop : loops)
    for (const json& curve : loop) {
      double least = off_side(curve, sides[0]);
      for (const side& from : sides) least = std::min(least, off_side(curve, from));
      most = std::max(most, least);
    }
  return most;
}

// Returns the face as a patch. A ball and a ring are faces that bound themselves alone; they have
// no loops, and their sides are joined as those of other patches, by their control points. A note
// says so.
json face_reader::patch() {
  // As a part of a parameter's range: chosen far above the roundings of OpenCASCADE's conversions,
  // and far below any length of a drawing. A note says how much was used.
  constexpr double rounding = 1e-12;
  const auto s = surface();
  json members = surface_members(*s), loops = json::array();
  for (TopExp_Explorer at(face, TopAbs_WIRE); at.More(); at.Next())
    loops.push_back(loop(TopoDS::Wire(at.Current())));
  const double off = off_sides(loops, *s);
  const bool is_whole = loops.size() == 1 && is_alone() && off <= rounding;
  if (!loops.empty() && !is_whole) members["loops"] = loops;
  if (is_whole)
    notes.push_back(name + ": its loop goes along the sides of its patch but for " + text_of(off) +
                    " of a parameter's range; it was left out, and all of the patch is meant");
  return members;
}

int convert(const std::string& in, const std::string& out) {
  const TopoDS_Shape shape = BRepBuilderAPI_NurbsConvert(read_shape(in), true).Shape();
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
  std::vector<std::string> notes;
  json patches = json::array();
  double tolerance = 0;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
    const TopoDS_Face& as_given = TopoDS::Face(at.Current());
    face_reader reader{TopoDS::Face(as_given.Oriented(TopAbs_FORWARD)),
                       "face " + std::to_string(patches.size() + 1),
                       as_given.Orientation() == TopAbs_REVERSED, edges, notes};
    patches.push_back(reader.patch());
  }
  for (int k = 1; k <= edges.Extent(); ++k)
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(edges.FindKey(k))));
  std::ofstream file(out);
  file << json{{"patches", patches}}.dump(1) << '\n';
  file.close();
  if (!file) throw refusal(out + ": it cannot be written");
  for (const std::string& note : notes) std::cerr << "asterism-occt: note: " << note << '\n';
  std::cout
      << patches.size() << " faces, " << edges.Extent()
      << " edges; lengths in millimetres, as OpenCASCADE reads them; greatest tolerance of an "
         "edge "
      << tolerance << '\n';
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) {
    std::cerr << "usage: asterism-occt IN.step|IN.brep OUT.json\n";
    return 2;
  }
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  try {
    return convert(words[1], words[2]);
  } catch (const refusal& why) {
    std::cerr << "asterism-occt: " << why.what() << '\n';
  } catch (const Standard_Failure& why) {
    std::cerr << "asterism-occt: " << words[1] << ": OpenCASCADE: " << why.GetMessageString()
              << '\n';
  } catch (const std::exception& why) {
    std::cerr << "asterism-occt: " << words[1] << ": " << why.what() << '\n';
  }
  return 2;
}
