// SPDX-License-Identifier: MIT
#include "asterism/mesh/fill/fill.hpp"

#include <algorithm>
#include <atomic>
#include <boost/container/deque.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "asterism/mesh/fill/domain_locator.hpp"
#include "asterism/mesh/fill/scattered_places.hpp"
#include "asterism/mesh/fill/segment_division.hpp"
#include "asterism/mesh/numerics/approximate_star.hpp"
#include "asterism/mesh/numerics/constructions.hpp"
#include "asterism/mesh/numerics/metric_box.hpp"
#include "asterism/mesh/search/box_index.hpp"
#include "asterism/mesh/search/hilbert_order.hpp"
#include "asterism/mesh/search/site_index.hpp"
#include "asterism/mesh/stars/proximity.hpp"
#include "asterism/mesh/support/parallel.hpp"

namespace asterism::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t chunk = 256;

// A new site must be farther than this part of the distance from all others as it measures itself;
// as they measure, the whole. Asking the whole of both leaves holes where the metric varies.
constexpr double own_part = 0.6;

struct proposal {
  site where;
  double squared_radius;
  vertex_index from;  // the centre of a star it is near
};

struct disturbed {
  vertex_index star, by;
};

class filling {
 public:
  filling(const domain& d, const metric_field& field, const fill_options& options,
          std::vector<division> divisions)
      : domain_(d),
        field_(field),
        options_(options),
        divisions_(std::move(divisions)),
        box_(d.box()),
        locator_(d),
        sites_index_(box_),
        subsegments_index_(box_) {}

  result<filled_domain> run(const fill_progress& progress) {
    int levels = 0;
    const double widest = longest_segment();
    while (!options_.is_uneven && levels < most_levels &&
           options_.distance * std::exp2(levels) < widest)
      ++levels;
    distance_ = options_.distance * std::exp2(levels);
    start();
    for (int level = levels; level >= 0 && !failure_ && !full_; --level) {
      distance_ = options_.distance * std::exp2(level);
      divide(level == 0 ? 0 : options_.longest_subsegment * std::exp2(level));
      while (!failure_ && !full_ && rounds_ < most_rounds) {
        if (progress && !progress(sites_.size(), needed_)) full_ = stopped_ = true;
        if (full_ || !round()) break;
      }
      needed_ = full_ ? std::max(needed_, static_cast<double>(sites_.size()))
                      : sites_at_last_level(level);
    }
    if (failure_) return *failure_;
    return outcome();
  }

 private:
  static constexpr int most_levels = 40;
  // Of how many sites the stars are made between two looks at the work done, once that is much.
  static constexpr std::size_t block = 1024;
  // Each round but the last of a level inserts a site; this only stops a run whose numbers have
  // gone wrong.
  static constexpr std::size_t most_rounds = 4000;

  // An interval of a segment's division that is one subsegment so far.
  struct interval {
    std::size_t segment, first, last;  // into the division's points
    vertex_index a, b;
  };

  // Half the distance takes twice the sites on segments and four times those inside.
  double sites_at_last_level(int level) const {
    const auto on_segments =
        static_cast<double>(std::count(on_segment_.begin(), on_segment_.end(), 1));
    const double inside = static_cast<double>(sites_.size()) - on_segments;
    return on_segments * std::exp2(level) + inside * std::exp2(2 * level);
  }

  // Counted, not timed, so that every fill ends at the same place; by sums that are the same for
  // any number of threads. Fills of metrics that sites can follow disturb 5 to 110 stars a site and
  // go through 30 to 2600 candidates a site; where metrics vary wildly every site disturbs a part
  // of all others, and both grow with the number of sites.
  bool is_overworked(std::uint64_t parts = 1) const {
    constexpr std::uint64_t at_least = 500'000, for_each = 200, candidates_for_one = 25;
    const std::uint64_t most = at_least + for_each * sites_.size();
    return parts * disturbed_ > most || parts * (candidates_ / candidates_for_one) > most;
  }

  double longest_segment() const {
    double longest = 0;
    for (const division& d : divisions_) longest = std::max(longest, d.lengths.back());
    return longest;
  }

  std::optional<site> site_at(const point& q) {
    const auto metric = field_.at(q);
    if (metric) return site{q, metric.value()};
    if (!failure_) failure_ = metric.failure();
    return std::nullopt;
  }

  void start() {
    for (const point& q : domain_.vertices) {
      const auto s = site_at(q);
      if (!s) return;
      add_site(*s, true);
    }
    is_isolated_.assign(sites_.size(), 1);
    for (const segment& one : domain_.segments) is_isolated_[one.a] = is_isolated_[one.b] = 0;
    at_division_.resize(divisions_.size());
    for (std::size_t s = 0; s < divisions_.size(); ++s) {
      at_division_[s].assign(divisions_[s].points.size(), no_site);
      const segment& one = domain_.segments[s];
      intervals_.push_back({s, 0, divisions_[s].points.size() - 1, one.a, one.b});
      insert_subsegment(intervals_.size() - 1);
    }
    if (options_.is_uneven) {
      halve_intervals(0);
      scatter();
    }
    fresh_from_ = 0;
    renew_stars();
  }

  // Sites inside before there is any star, twice as far from each other as they will be: the rest
  // goes farthest first, which makes better triangles.
  void scatter() {
    constexpr std::size_t for_each_site = 16, at_least = 4096;
    distance_ *= 2;
    const filtered_kernel kernel;
    visit_scattered(box_, at_least + for_each_site * sites_.size(),
                    [&](const point& q, const point& half) { return scatter_at(kernel, q, half); });
    distance_ /= 2;
  }

  // A site at q if there is room. Whether a cell with this half of its diagonal may have more.
  bool scatter_at(const filtered_kernel& kernel, const point& q, const point& half) {
    const auto metric = field_.at(q);
    if (!metric || full_) return false;
    const site s{q, metric.value()};
    std::uint64_t looked_at = 0;
    if (has_room(sites_index_, s, looked_at) && stays_clear(s, looked_at) &&
        locator_.contains(kernel, q) && !is_out_of_room())
      add_site(s, false);
    candidates_ += looked_at;
    const double rising = squared_length(s.metric, half);
    const double falling = squared_length(s.metric, {half.x, -half.y});
    return std::max(rising, falling) > distance_ * distance_;
  }

  void add_site(const site& s, bool on_segment) {
    sites_.push_back(s);
    on_segment_.push_back(on_segment);
    sites_index_.insert(sites_, static_cast<vertex_index>(sites_.size() - 1));
  }
  bool is_out_of_room() {
    full_ = full_ || sites_.size() >= options_.max_sites;
    return full_;
  }

  bounding_box subsegment_box(std::size_t i) const {
    return box_of(sites_[intervals_[i].a].position, sites_[intervals_[i].b].position);
  }
  void insert_subsegment(std::size_t i) {
    subsegments_index_.insert(static_cast<std::uint32_t>(i), subsegment_box(i));
  }

  void divide(double longest) {
    fresh_from_ = sites_.size();
    halve_intervals(longest);
    renew_stars();
    changed_.resize(sites_.size());
    for (vertex_index v = 0; v < sites_.size(); ++v)
      changed_[v] = v;  // the distance is new as well
  }

  // Those that are longer than `longest`.
  void halve_intervals(double longest) {
    for (std::size_t i = 0; i < intervals_.size() && !failure_ && !full_;) {
      const interval now = intervals_[i];
      const division& d = divisions_[now.segment];
      if (now.last == now.first + 1 || d.lengths[now.last] - d.lengths[now.first] <= longest) {
        ++i;
        continue;
      }
      if (is_out_of_room()) break;
      const std::size_t middle = now.first + (now.last - now.first) / 2;
      const auto s = site_at(d.points[middle]);
      if (!s) return;
      add_site(*s, true);
      const auto m = static_cast<vertex_index>(sites_.size() - 1);
      at_division_[now.segment][middle] = m;
      subsegments_index_.remove(static_cast<std::uint32_t>(i), subsegment_box(i));
      intervals_[i] = {now.segment, now.first, middle, now.a, m};
      intervals_.push_back({now.segment, middle, now.last, m, now.b});
      insert_subsegment(i);
      insert_subsegment(intervals_.size() - 1);
    }
  }

  // --- One round: proposals, a choice of them, the stars around.

  bool round() {
    ++rounds_;
    std::vector<proposal> proposals = collect_chunks<proposal>(
        changed_.size(), chunk,
        [&](std::size_t begin, std::size_t end, std::vector<proposal>& out) {
          const filtered_kernel kernel;
          std::uint64_t looked_at = 0;
          for (std::size_t i = begin; i < end; ++i) propose(kernel, changed_[i], looked_at, out);
          candidates_ += looked_at;
        });
    if (const auto at =
            std::find_if(proposals.begin(), proposals.end(),
                         [](const proposal& p) { return p.squared_radius == infinity; });
        at != proposals.end()) {
      site_at(at->where.position);  // the field failed there
      return false;
    }
    choose(proposals);
    const bool any = fresh_from_ < sites_.size();
    if (any) renew_stars();
    return any;
  }

  // The Voronoi vertices of the star's triangles that are far enough from all sites and inside.
  void propose(const filtered_kernel& kernel, vertex_index v, std::uint64_t& looked_at,
               std::vector<proposal>& out) const {
    const plain_star& star = stars_[v];
    const point& centre = sites_[v].position;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const plain_gap& gap = star[i];
      const vertex_index next = star[i + 1 < star.size() ? i + 1 : 0].neighbour;
      const bool found = gap.squared_radius < infinity;
      if (!(gap.squared_radius > distance_ * distance_) || !(found || options_.is_uneven)) continue;
      if (v > gap.neighbour || (found && v > next)) continue;  // another star proposes it
      point q{centre.x + gap.vertex.x, centre.y + gap.vertex.y};
      double squared_radius = gap.squared_radius;
      if (!found) {
        q = bisector_point(sites_[v], sites_[gap.neighbour]);
        squared_radius = squared_distance(sites_[v], q);
        if (!(squared_radius > distance_ * distance_)) continue;
      }
      if (q.x < box_.low.x || q.x > box_.high.x || q.y < box_.low.y || q.y > box_.high.y) continue;
      const auto metric = field_.at(q);
      if (!metric) {
        if (locator_.contains(kernel, q)) out.push_back({{q, {}}, infinity, v});
        continue;
      }
      const site s{q, metric.value()};
      if (has_room(sites_index_, s, looked_at) && stays_clear(s, looked_at) &&
          locator_.contains(kernel, q))
        out.push_back({s, squared_radius, v});
    }
  }

  bool has_room(const site_index& among, const site& s, std::uint64_t& looked_at) const {
    const double squared = distance_ * distance_, own = own_part * own_part * squared;
    // Metrics that differ more than this within the distance are beyond what the net can do.
    constexpr double margin = 1.25;
    const bounding_box near = box_around(s, margin * distance_);
    return among.visit_box(sites_, near.low, near.high, [&](vertex_index w) {
      ++looked_at;
      return squared_distance(sites_[w], s.position) > squared &&
             squared_distance(s, sites_[w].position) > own;
    });
  }

  // Whether no subsegment has its bisector point nearer to s than to its ends.
  bool stays_clear(const site& s, std::uint64_t& looked_at) const {
    const bounding_box near = box_around(s, distance_);
    return subsegments_index_.visit(near, [&](std::uint32_t i) {
      ++looked_at;
      const site &a = sites_[intervals_[i].a], &b = sites_[intervals_[i].b];
      const point m = bisector_point(a, b);
      return squared_distance(s, m) > squared_distance(a, m);
    });
  }

  // Farthest first, in bands, so that neighbours in memory stay neighbours.
  void choose(std::vector<proposal>& proposals) {
    const auto band = [&](const proposal& p) {
      return static_cast<int>(2 * std::log2(p.squared_radius / (distance_ * distance_)));
    };
    std::stable_sort(proposals.begin(), proposals.end(),
                     [&](const proposal& a, const proposal& b) { return band(a) > band(b); });
    fresh_from_ = sites_.size();
    site_index chosen(box_);
    std::uint64_t looked_at = 0;
    for (const proposal& p : proposals) {
      if (!has_room(chosen, p.where, looked_at)) continue;
      if (is_out_of_room()) break;
      add_site(p.where, false);
      chosen.insert(sites_, static_cast<vertex_index>(sites_.size() - 1));
    }
    candidates_ += looked_at;
  }

  // Stars of the sites since fresh_from_, and of those they disturb. Sets changed_.
  void renew_stars() {
    stars_.resize(sites_.size());
    std::vector<disturbed> pairs;
    for (std::size_t at = fresh_from_; at < sites_.size() && !full_;) {
      constexpr std::uint64_t quarter = 4;
      const std::size_t end =
          is_overworked(quarter) ? std::min(sites_.size(), at + block) : sites_.size();
      const std::vector<disturbed> more = make_stars(at, end);
      pairs.insert(pairs.end(), more.begin(), more.end());
      disturbed_ += more.size();
      at = end;
      if (is_overworked()) full_ = crowded_ = true;
    }
    std::sort(pairs.begin(), pairs.end(), [](const disturbed& a, const disturbed& b) {
      return a.star != b.star ? a.star < b.star : a.by < b.by;
    });
    changed_.clear();
    if (!full_) renew_disturbed(pairs);
    for (std::size_t w = fresh_from_; w < sites_.size(); ++w)
      changed_.push_back(static_cast<vertex_index>(w));
  }

  // Of the sites from `first` to before `last`, and which stars of older ones they disturb.
  std::vector<disturbed> make_stars(std::size_t first, std::size_t last) {
    return collect_chunks<disturbed>(
        last - first, chunk, [&](std::size_t begin, std::size_t end, std::vector<disturbed>& out) {
          std::vector<vertex_index> near;
          std::uint64_t looked_at = 0;
          for (std::size_t i = begin; i < end; ++i) {
            const auto w = static_cast<vertex_index>(first + i);
            if (is_enough(i)) break;
            build_with_neighbourhood(w, near, looked_at);
            for (const vertex_index u : near)
              if (u < fresh_from_ && disturbs(sites_, u, stars_[u], w)) out.push_back({u, w});
          }
          candidates_ += looked_at;
        });
  }

  // The pairs are sorted by star, which is added to changed_.
  void renew_disturbed(const std::vector<disturbed>& pairs) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (i == 0 || pairs[i].star != pairs[i - 1].star) starts.push_back(i);
    starts.push_back(pairs.size());
    parallel_chunks(starts.size() - 1, chunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::vector<vertex_index> candidates;
      std::uint64_t looked_at = 0;
      for (std::size_t i = begin; i < end; ++i) {
        if (is_enough(i)) break;
        const vertex_index v = pairs[starts[i]].star;
        candidates.clear();
        for (const plain_gap& gap : stars_[v]) candidates.push_back(gap.neighbour);
        for (std::size_t j = starts[i]; j < starts[i + 1]; ++j) candidates.push_back(pairs[j].by);
        looked_at += candidates.size();
        stars_[v] = build_plain_star(sites_, v, candidates);
      }
      candidates_ += looked_at;
    });
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) changed_.push_back(pairs[starts[i]].star);
  }

  bool is_enough(std::size_t i) const {
    constexpr std::size_t at_a_time = 8;
    return options_.enough && i % at_a_time == 0 && options_.enough();
  }

  // The star of w among all sites so near that no farther one could belong to it; `near` is left
  // holding them.
  void build_with_neighbourhood(vertex_index w, std::vector<vertex_index>& near,
                                std::uint64_t& looked_at) {
    const site& s = sites_[w];
    const double ordinary = 2.2 * distance_;
    const double dense = is_isolated(w) ? first_reach_among_dense(s) : infinity;
    double reach = dense < ordinary ? dense : ordinary;
    for (int attempt = 0; attempt < 64; ++attempt, reach *= 2) {
      near.clear();
      const bounding_box box = box_around(s, reach);
      const bool all = box.low.x <= box_.low.x && box.low.y <= box_.low.y &&
                       box.high.x >= box_.high.x && box.high.y >= box_.high.y;
      sites_index_.visit_box(sites_, box.low, box.high, [&](vertex_index u) {
        ++looked_at;
        if (u != w && (all || squared_distance(s, sites_[u].position) <= reach * reach))
          near.push_back(u);
        return true;
      });
      if (near.size() < 3 && !all) continue;
      stars_[w] = build_plain_star(sites_, w, near);
      if (all) return;
      double widest = 0;
      for (const plain_gap& gap : stars_[w]) widest = std::max(widest, gap.squared_radius);
      // At the boundary there may be no neighbour on the outer side, however far one looks; nor
      // behind sites for which lengths count much more. At the rim of many given sites the way to
      // the next ones is long, and what is looked at on it is bounded.
      constexpr int enough_attempts = 2;
      constexpr std::size_t many = 512;
      const bool is_open =
          on_segment_[w] != 0 || (options_.is_uneven && attempt >= enough_attempts);
      const bool is_tried = attempt >= enough_attempts && near.size() > many;
      const bool is_hopeless = is_open && (reach >= ordinary || is_tried);
      if (2.1 * std::sqrt(widest) <= reach || is_hopeless) return;
    }
  }

  // Where given sites lie much closer than the distance: their spacing, to begin with, so that no
  // star is made from a large part of them all. Infinite elsewhere.
  double first_reach_among_dense(const site& s) const {
    constexpr double much_closer = 0.25, spacings = 2.2;
    const double spacing = sites_index_.spacing_near(s);
    return spacing > 0 && spacing < much_closer * distance_ ? spacings * spacing : infinity;
  }
  bool is_isolated(vertex_index w) const { return w < is_isolated_.size() && is_isolated_[w] != 0; }

  // The site whose star has most neighbours; of several, the first.
  std::optional<crowded_site> most_crowded() const {
    if (!crowded_ || stars_.empty()) return std::nullopt;
    const auto most = std::max_element(
        stars_.begin(), stars_.end(),
        [](const plain_star& a, const plain_star& b) { return a.size() < b.size(); });
    const auto at = static_cast<std::size_t>(most - stars_.begin());
    return crowded_site{sites_[at].position, most->size(), sites_.size()};
  }

  result<filled_domain> outcome() const {
    filled_domain filled;
    filled.rounds = rounds_;
    filled.complete = !full_;
    filled.stopped = stopped_;
    filled.needed = needed_;
    filled.crowded = most_crowded();
    filled.divisions.resize(divisions_.size());
    for (std::size_t s = 0; s < divisions_.size(); ++s)
      for (const vertex_index m : at_division_[s])
        if (m != no_site) filled.divisions[s].push_back(sites_[m]);
    for (std::size_t w = domain_.vertices.size(); w < sites_.size(); ++w)
      if (on_segment_[w] == 0) filled.interior.push_back(sites_[w]);
    sort_along_curve(filled.interior, box_);
    return filled;
  }

  static constexpr vertex_index no_site = std::numeric_limits<vertex_index>::max();

  const domain& domain_;
  const metric_field& field_;
  const fill_options& options_;
  std::vector<division> divisions_;
  bounding_box box_;
  domain_locator locator_;
  std::vector<site> sites_;
  std::vector<char> on_segment_;   // by site; the given vertices count
  std::vector<char> is_isolated_;  // by given vertex: on no segment
  site_index sites_index_;
  // Many and large: a vector would hold them twice while it grows.
  using star_blocks = boost::container::deque_options_t<boost::container::block_size<1024>>;
  boost::container::deque<plain_star, void, star_blocks> stars_;
  std::vector<interval> intervals_;
  box_index subsegments_index_;
  std::vector<std::vector<vertex_index>> at_division_;  // the site at each point of a division
  std::vector<vertex_index> changed_;                   // stars that may propose something new
  std::size_t fresh_from_ = 0;                          // the sites without stars yet
  double distance_ = 0;                                 // of the level
  std::size_t rounds_ = 0;
  bool full_ = false;     // a site was wanted and there was no room
  bool stopped_ = false;  // by `progress`, which makes it full
  bool crowded_ = false;  // is_overworked(), which makes it full as well
  // Of all rounds: stars disturbed by new sites, and sites and subsegments looked at as candidates.
  std::uint64_t disturbed_ = 0;
  std::atomic<std::uint64_t> candidates_ = 0;
  double needed_ = 0;
  std::optional<error> failure_;
};

}  // namespace

result<filled_domain> fill(const domain& d, const metric_field& field, const fill_options& options,
                           const fill_progress& progress) {
  auto divisions = divide_segments(d, field, options.longest_subsegment, options.max_sites);
  if (!divisions) return divisions.failure();
  if (divisions.value().of_each.empty() && !d.segments.empty()) {
    filled_domain nothing;
    nothing.divisions.resize(d.segments.size());
    nothing.needed = divisions.value().subsegments;
    return nothing;
  }
  return filling(d, field, options, std::move(divisions.value().of_each)).run(progress);
}

}  // namespace asterism::internal
