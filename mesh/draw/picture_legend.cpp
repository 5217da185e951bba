// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/picture_legend.hpp"

#include <algorithm>

#include "asterism/mesh/draw/stroke_letters.hpp"

namespace asterism::internal {
namespace {

constexpr colour ink{0.07, 0.09, 0.13};

// Lengths of a legend, for a picture of this width.
struct measures {
  explicit measures(double width) : unit(width / 1000) {}
  double unit;
  double letter = 13 * unit, row = 30 * unit, box = 16 * unit, bar = 240 * unit, gap = 9 * unit;
};

// Places boxes from left to right, and in a new row when one would not fit.
class rows {
 public:
  rows(const point& corner, double width, const measures& m)
      : left_(corner.x), right_(corner.x + width), row_(m.row), gap_(m.gap), at_(corner) {}
  point next(double wide) {
    if (at_.x > left_ && at_.x + wide > right_) at_ = {left_, at_.y + row_};
    const point here = at_;
    at_.x += wide + 2 * gap_;
    return here;
  }
  double bottom() const { return at_.y + row_; }

 private:
  double left_, right_, row_, gap_;
  point at_;
};

double bar_width(const picture_legend& l, const measures& m) {
  double wide = m.bar + 2 * m.gap;
  for (const std::string* text : {&l.low, &l.high}) wide += text_width(*text, m.letter);
  if (!l.title.empty()) wide += text_width(l.title, m.letter) + 2 * m.gap;
  return wide;
}

void write(canvas& on, const measures& m, const point& at, const std::string& text) {
  on.use(ink);
  draw_text(on, {at.x, at.y + 0.5 * (m.box + m.letter)}, m.letter, text);
}

void fill_box(canvas& on, const point& at, double wide, double high, const colour& c) {
  on.begin_path();
  on.move_to(at);
  on.line_to({at.x + wide, at.y});
  on.line_to({at.x + wide, at.y + high});
  on.line_to({at.x, at.y + high});
  on.close_path();
  on.use(c);
  on.fill();
}

// Draws a bar in 64 steps, which the eye hardly distinguishes. Each step is drawn to the bar's
// right end, so that there are no seams.
void draw_bar(canvas& on, const picture_legend& l, const measures& m, point at) {
  constexpr int steps = 64;
  const auto after = [&](const std::string& text, double gap) {
    write(on, m, at, text);
    at.x += text_width(text, m.letter) + gap;
  };
  if (!l.title.empty()) after(l.title, 2 * m.gap);
  after(l.low, m.gap);
  for (int i = 0; i < steps; ++i) {
    const double place = (i + 0.5) / steps * static_cast<double>(l.bar.size() - 1);
    const std::size_t k = std::min(l.bar.size() - 2, static_cast<std::size_t>(place));
    const double s = place - static_cast<double>(k);
    const colour &a = l.bar[k], &b = l.bar[k + 1];
    fill_box(on, {at.x + m.bar * i / steps, at.y}, m.bar * (steps - i) / steps, m.box,
             {a.red + (b.red - a.red) * s, a.green + (b.green - a.green) * s,
              a.blue + (b.blue - a.blue) * s});
  }
  at.x += m.bar + m.gap;
  after(l.high, 0);
}

double box_width(const std::string& text, const measures& m) {
  return m.box + m.gap + text_width(text, m.letter);
}

}  // namespace

double legend_height(const picture_legend& legend, double width) {
  if (legend.is_empty()) return 0;
  const measures m(width);
  rows place({0, 0}, 0.94 * width, m);
  if (!legend.bar.empty()) place.next(bar_width(legend, m));
  for (const auto& box : legend.boxes) place.next(box_width(box.second, m));
  return place.bottom();
}

void draw_legend(canvas& on, const picture_legend& legend, const point& corner, double width) {
  if (legend.is_empty()) return;
  const measures m(width);
  rows place(corner, 0.94 * width, m);
  if (!legend.bar.empty()) draw_bar(on, legend, m, place.next(bar_width(legend, m)));
  for (const auto& [c, name] : legend.boxes) {
    const point at = place.next(box_width(name, m));
    fill_box(on, at, m.box, m.box, c);
    write(on, m, {at.x + m.box + m.gap, at.y}, name);
  }
}

}  // namespace asterism::internal
