// SPDX-License-Identifier: MIT
//
// Measures the quality of a mesh in its metric, beyond its certificate: lengths, quality, count,
// and how fast the metric varies in it. In doubles, for reports.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "asterism/core/export.h"
#include "asterism/mesh/data/mesh.hpp"

namespace asterism {

// Returns max(||F_p F_q^-1||, ||F_q F_p^-1||), F^T F = M: the factor by which two metrics differ at
// most, in length. At least 1; infinite when it cannot be computed.
ASTERISM_EXPORT double distortion(const metric_tensor& p, const metric_tensor& q);

// Returns the least sigma for which the two sites obey tau <= 1 / (1 - sigma d) for both their
// distances d, hence for the smaller one: how fast the metric varies per unit of its own length.
// Source: docs/math/refinement.md, hypothesis H1.
ASTERISM_EXPORT double variation(const site& p, const site& q);

// Returns length over width of the metric's unit circle: the root of its condition number.
ASTERISM_EXPORT double aspect(const metric_tensor& m);

// Area and quality of one triangle in the mean metric of its three sites. The area is negative when
// it turns clockwise; the quality is 4 sqrt 3 area / sum of squared lengths, 1 for an equilateral
// one.
struct triangle_shape {
  double area = 0, quality = 0;
};
// Returns area and quality of one triangle.
ASTERISM_EXPORT triangle_shape shape_of(const triangle_sites& t);

// Statistics of a mesh in its metric.
struct mesh_statistics {
  std::size_t edges = 0;
  // Share of the edges of metric length in [1/sqrt 2, sqrt 2], and the mean length. A length is the
  // mean of both ends' lengths.
  double unit_edges = 0, mean_length = 0;
  // Mean and least quality of all triangles.
  double mean_quality = 0, least_quality = 0;
  // Share of the triangles whose smallest angle, by the metrics of all three vertices, is below 20
  // and below 30 degrees.
  double below_20 = 0, below_30 = 0;
  // Area of the domain by the metrics at the vertices; and the number of triangles, as a multiple
  // of that of unit equilateral triangles with this area.
  double metric_area = 0, count_ratio = 0;
  // Greatest aspect (length over width of the unit circle) of a vertex's metric.
  double aspect = 0;
  // The largest variation over an edge, the largest distance from a triangle's sites to their
  // Voronoi vertex, and the product of both, which the theorem on refinement bounds.
  double sigma = 0, eps = 0, sigma_eps = 0;
};

// Returns the statistics of a mesh.
ASTERISM_EXPORT mesh_statistics measure(const mesh& m);

// Returns all statistics by name, as certificates hold them.
ASTERISM_EXPORT std::map<std::string, double> by_name(const mesh_statistics& s);

}  // namespace asterism
