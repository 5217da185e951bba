// SPDX-License-Identifier: MIT
//
// Defines sizes wanted at places (at a point, in a box, in a region, near a part of
// the boundary, in layers along it) and bounds on all sizes: the values of
// --size-at, --size-box, --size-in, --size-near, --layers, --hmin, --hmax and
// --aspect.
//
// Units: lengths are the domain's. `growth` is the factor between neighbouring edges, or heights of
// layers, away from the place: with the distance d from it a size grows to size + (growth - 1) d,
// which is what a row of edges, each `growth` times the one before, has at its end.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asterism/core/export.h"
#include "asterism/core/result.hpp"
#include "asterism/core/site.hpp"
#include "asterism/mesh/data/bounding_box.hpp"

namespace asterism {

// Growth of sizes away from their place where none is named.
inline constexpr double usual_growth = 1.3;

// Size in a circle; at a point where the radius is 0.
struct size_at {
  point centre;
  double radius = 0, size = 0, growth = usual_growth;
};

// Size in a box.
struct size_in_box {
  bounding_box box;
  double size = 0, growth = usual_growth;
};

// Size in the region with this number.
struct size_in_region {
  int region = 1;
  double size = 0, growth = usual_growth;
};

// Size along the segments with this marker.
struct size_near {
  int marker = 0;
  double size = 0, growth = usual_growth;
};

// Layers along the segments with this marker, on every side that the domain is on. Beyond the last
// one, where their number is given, heights grow with the usual growth if that is more.
struct boundary_layers {
  int marker = 0;
  double first_height = 0, growth = 1.2;
  std::optional<int> layers = {};
};

// Sizes wanted, of which the finest counts at every place, and bounds on the sizes of all.
struct size_wishes {
  std::vector<size_at> at = {};
  std::vector<size_in_box> boxes = {};
  std::vector<size_in_region> regions = {};
  std::vector<size_near> near = {};
  std::vector<boundary_layers> layers = {};
  double least = 0, greatest = std::numeric_limits<double>::infinity();  // lengths of an edge
  double aspect = 1e6;  // how many times as long as wide a triangle may be

  // True if no size and no bound is given.
  ASTERISM_EXPORT bool is_empty() const;
};

// Adds the wish `kind` with these values: "at" X,Y,R:H[,GROWTH]; "box" X0,Y0,X1,Y1:H[,GROWTH]; "in"
// REGION:H[,GROWTH]; "near" MARKER:H[,GROWTH]; "layers" MARKER:H0,GROWTH[,N]; "hmin", "hmax" H;
// "aspect" A. Lengths from 1e-150 to 1e150, growth and aspect from 1 to 1e6, N from 1 to 10000.
// Fails for anything else, saying what in half a sentence.
ASTERISM_EXPORT result<size_wishes> with_wish(size_wishes all, std::string_view kind,
                                              std::string_view values);

// Returns the wishes as text, "in 2:0.1,1.3; hmax 1": numbers read back as they were. Nothing
// wished is "none".
ASTERISM_EXPORT std::string text_of(const size_wishes& wishes);
// Reads the wishes from a text as text_of() returns it.
ASTERISM_EXPORT result<size_wishes> size_wishes_of(std::string_view text);

}  // namespace asterism
