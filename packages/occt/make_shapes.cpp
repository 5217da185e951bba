// SPDX-License-Identifier: MIT
//
// Writes shapes for the tests: box, can, drilled, fillet, posts, crossed, ball, ring as NAME.brep,
// and drilled.step.
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>
#include <string>

int main(int count, char** words) {
  if (count != 2) return 2;
  const std::string folder = std::string(words[1]) + "/";
  const auto write = [&](const TopoDS_Shape& shape, const char* name) {
    return BRepTools::Write(shape, (folder + name + ".brep").c_str());
  };
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 10).Shape();
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 10, -1), gp_Dir(0, 0, 1)), 4, 12).Shape();
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(box, drill).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer at(box, TopAbs_EDGE); at.More(); at.Next())
    fillet.Add(2, TopoDS::Edge(at.Current()));
  // Rounds the four edges along z.
  BRepFilletAPI_MakeFillet posts(box);
  for (TopExp_Explorer at(box, TopAbs_EDGE); at.More(); at.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(at.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
                 b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (a.Z() != b.Z()) posts.Add(2, edge);
  }
  const TopoDS_Shape upright =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -15), gp_Dir(0, 0, 1)), 4, 30).Shape();
  const TopoDS_Shape lying =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, -15, 0), gp_Dir(0, 1, 0)), 4, 30).Shape();
  const TopoDS_Shape crossed = BRepAlgoAPI_Fuse(upright, lying).Shape();
  STEPControl_Writer step;
  step.Transfer(drilled, STEPControl_AsIs);
  const bool written = write(box, "box") && write(BRepPrimAPI_MakeCylinder(5, 8).Shape(), "can") &&
                       write(drilled, "drilled") && write(fillet.Shape(), "fillet") &&
                       write(posts.Shape(), "posts") && write(crossed, "crossed") &&
                       write(BRepPrimAPI_MakeSphere(5).Shape(), "ball") &&
                       write(BRepPrimAPI_MakeTorus(10, 3).Shape(), "ring") &&
                       step.Write((folder + "drilled.step").c_str()) == IFSelect_RetDone;
  return written ? 0 : 1;
}
