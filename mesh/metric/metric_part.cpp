// SPDX-License-Identifier: MIT
#include "asterism/mesh/metric/metric_part.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "asterism/core/number_text.hpp"
#include "asterism/mesh/data/site_box.hpp"
#include "asterism/mesh/metric/background_field.hpp"
#include "asterism/mesh/support/tensor_text.hpp"

namespace asterism::internal {
namespace {

bounding_box grown(const bounding_box& box, double by) {
  return {{box.low.x - by, box.low.y - by}, {box.high.x + by, box.high.y + by}};
}

bool meet(const bounding_box& a, const bounding_box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

// Returns the distance of the point from the box: the larger of those along x and y.
double distance_outside(const point& q, const bounding_box& box) {
  return std::max({box.low.x - q.x, q.x - box.high.x, box.low.y - q.y, q.y - box.high.y, 0.0});
}

class part_field final : public sized_field {
 public:
  explicit part_field(const metric_part& part)
      : sized_field(part.size), window_(part.window), margin_(part.margin) {
    if (!part.given.triangles.empty()) metric_.emplace(part.given, part.whole);
  }

 private:
  result<metric_tensor> unsized(const point& q) const override {
    const double reach = margin_ - distance_outside(q, window_);
    if (metric_ && reach >= 0)
      if (const auto found = metric_->at_within(q, reach)) return *found;
    return error{"the mesh of the metric has no triangle within " + format_number(margin_) +
                     " of " + point_text(q) +
                     ": pieces want a metric on a mesh that covers the domain",
                 error_code::invalid_metric};
  }

  bounding_box window_;
  double margin_;
  std::optional<background_metric> metric_;
};

// Appends numbers to a list of bytes.
class byte_writer {
 public:
  template <class T>
  void put(const T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (count > 0) text_.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }
  template <class T>
  void put(const T& value) {
    put(&value, 1);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

class byte_reader {
 public:
  explicit byte_reader(const std::string& text) : text_(text) {}

  template <class T>
  bool get(T* values, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (count > (text_.size() - at_) / sizeof(T)) return false;
    if (count > 0) std::memcpy(values, text_.data() + at_, count * sizeof(T));
    at_ += count * sizeof(T);
    return true;
  }
  template <class T>
  bool get(T& value) {
    return get(&value, 1);
  }
  template <class T>
  bool get(std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!get(count) || count > (text_.size() - at_) / sizeof(T)) return false;
    values.resize(count);
    return get(values.data(), count);
  }
  bool is_at_end() const { return at_ == text_.size(); }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<metric_part> part_of(const metric_field& field, const bounding_box& window) {
  const auto* const whole = dynamic_cast<const background_field*>(&field);
  if (whole == nullptr) return std::nullopt;
  constexpr double share = 1.0 / 8;
  metric_part part;
  part.whole = box_of_sites(whole->background()->sites);
  part.window = window;
  part.margin = share * std::max(window.high.x - window.low.x, window.high.y - window.low.y);
  part.size = whole->size();
  const bounding_box around = grown(window, part.margin);
  const std::vector<point>& places = whole->without_size().places();
  constexpr vertex_index left_out = std::numeric_limits<vertex_index>::max();
  std::vector<vertex_index> number(places.size(), left_out);
  for (triangle t : whole->background()->triangles) {
    bounding_box box = box_of(places[t[0]], places[t[1]]);
    box.include(places[t[2]]);
    if (!meet(box, around)) continue;
    for (vertex_index& v : t) {
      if (number[v] == left_out) {
        number[v] = static_cast<vertex_index>(part.given.sites.size());
        part.given.sites.push_back({places[v], whole->without_size().tensors()[v]});
      }
      v = number[v];
    }
    part.given.triangles.push_back(t);
  }
  return part;
}

std::unique_ptr<metric_field> make_field_of_part(const metric_part& part) {
  return std::make_unique<part_field>(part);
}

std::string bytes_of(const metric_part& part) {
  byte_writer bytes;
  bytes.put(part.whole);
  bytes.put(part.window);
  bytes.put(part.margin);
  bytes.put(part.size);
  bytes.put(std::uint64_t{part.given.sites.size()});
  bytes.put(part.given.sites.data(), part.given.sites.size());
  bytes.put(std::uint64_t{part.given.triangles.size()});
  bytes.put(part.given.triangles.data(), part.given.triangles.size());
  return bytes.take();
}

result<metric_part> metric_part_in(const std::string& bytes, const std::string& name) {
  byte_reader reader(bytes);
  metric_part part;
  const bool is_whole = reader.get(part.whole) && reader.get(part.window) &&
                        reader.get(part.margin) && reader.get(part.size) &&
                        reader.get(part.given.sites) && reader.get(part.given.triangles) &&
                        reader.is_at_end();
  const auto has_corners = [&](const triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](vertex_index v) { return v < part.given.sites.size(); });
  };
  if (!is_whole ||
      !std::all_of(part.given.triangles.begin(), part.given.triangles.end(), has_corners))
    return error{name + ": it was changed while the run went on", error_code::unreadable_file};
  return part;
}

}  // namespace asterism::internal
