// SPDX-License-Identifier: MIT
//
// Defines the concept of a kernel: the ten predicates, each with the same arguments, answered for
// certain by all, or by all with an answer that may be empty. Every kernel asserts the concept, so
// that all stay alike.
#pragma once

#include <concepts>

#include "asterism/core/sign.hpp"
#include "asterism/core/site.hpp"

namespace asterism::internal {

template <class Truth>
using certain_answer = Truth;

// True if the member function `Question` of Kernel is const and gives Answer for these arguments.
template <class Question, class Kernel, class Answer, class... Argument>
concept asks = std::same_as<Question, Answer (Kernel::*)(const Argument&...) const>;

template <class K, template <class> class Answer>
concept answers_predicates =
    asks<decltype(&K::orientation), K, Answer<sign>, point, point, point> &&
    asks<decltype(&K::is_positive_definite), K, Answer<bool>, metric_tensor> &&
    asks<decltype(&K::compare_distance), K, Answer<sign>, site, site, point> &&
    asks<decltype(&K::in_wedge), K, Answer<bool>, site, site, point> &&
    asks<decltype(&K::dominates), K, Answer<sign>, site, site, point> &&
    asks<decltype(&K::voronoi_vertex_count), K, Answer<int>, site, site, site> &&
    asks<decltype(&K::arc_intersection_count), K, Answer<int>, site, site, site> &&
    asks<decltype(&K::encroaches), K, Answer<bool>, site, site, site> &&
    asks<decltype(&K::insertion_test), K, Answer<bool>, site, site, site, site> &&
    asks<decltype(&K::edge_test), K, Answer<bool>, site, site, site, site>;

template <class K>
concept predicate_kernel =
    answers_predicates<K, certain_answer> || answers_predicates<K, uncertain>;

}  // namespace asterism::internal
