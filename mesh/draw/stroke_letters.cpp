// SPDX-License-Identifier: MIT
#include "asterism/mesh/draw/stroke_letters.hpp"

#include <algorithm>
#include <array>

namespace asterism::internal {
namespace {

// Strokes of the characters from 33 to 126. Each is a line through points of two digits each,
// across from 0 to 4 and up from 0 to 8; the base line is at 2, small letters end at 6.
constexpr std::array<std::string_view, 94> strokes = {
    "08 04;02 02",                                      // !
    "08 06;28 26",                                      // "
    "18 12;38 32;06 46;04 44",                          // #
    "47 38 18 07 06 15 35 44 43 32 12 03;28 22",        // $
    "02 48;08 18;32 42",                                // %
    "42 07 18 27 26 03 12 22 44",                       // &
    "08 06",                                            // '
    "18 06 04 12",                                      // (
    "08 16 14 02",                                      // )
    "28 24;07 45;47 05",                                // *
    "05 45;27 23",                                      // +
    "12 00",                                            // ,
    "05 35",                                            // -
    "02 02",                                            // .
    "02 48",                                            // /
    "18 38 47 43 32 12 03 07 18",                       // 0
    "06 28 22",                                         // 1
    "07 18 38 47 46 02 42",                             // 2
    "07 18 38 47 46 35 25;35 44 43 32 12 03",           // 3
    "32 38 04 44",                                      // 4
    "48 08 05 35 44 43 32 12 03",                       // 5
    "47 38 18 07 03 12 32 43 44 35 15 04",              // 6
    "08 48 22",                                         // 7
    "15 06 07 18 38 47 46 35 15 04 03 12 32 43 44 35",  // 8
    "03 12 32 43 47 38 18 07 06 15 35 46",              // 9
    "06 06;02 02",                                      // :
    "16 16;12 00",                                      // ;
    "46 04 42",                                         // <
    "04 44;06 46",                                      // =
    "06 44 02",                                         // >
    "07 18 38 47 46 25 24;22 22",                       // ?
    "34 36 26 24 34 45 47 38 18 07 03 12 42",           // @
    "02 28 42;14 34",                                   // A
    "02 08 38 47 46 35 05;35 44 43 32 02",              // B
    "47 38 18 07 03 12 32 43",                          // C
    "02 08 28 46 44 22 02",                             // D
    "48 08 02 42;05 35",                                // E
    "48 08 02;05 35",                                   // F
    "47 38 18 07 03 12 32 43 45 25",                    // G
    "08 02;48 42;05 45",                                // H
    "08 02",                                            // I
    "48 43 32 12 03",                                   // J
    "08 02;48 05 42",                                   // K
    "08 02 42",                                         // L
    "02 08 25 48 42",                                   // M
    "02 08 42 48",                                      // N
    "18 38 47 43 32 12 03 07 18",                       // O
    "02 08 38 47 46 35 05",                             // P
    "18 38 47 43 32 12 03 07 18;24 42",                 // Q
    "02 08 38 47 46 35 05;25 42",                       // R
    "47 38 18 07 06 15 35 44 43 32 12 03",              // S
    "08 48;28 22",                                      // T
    "08 03 12 32 43 48",                                // U
    "08 22 48",                                         // V
    "08 12 25 32 48",                                   // W
    "08 42;02 48",                                      // X
    "08 25 48;25 22",                                   // Y
    "08 48 02 42",                                      // Z
    "18 08 02 12",                                      // [
    "08 42",                                            // backslash
    "08 18 12 02",                                      // ]
    "06 28 46",                                         // ^
    "01 41",                                            // _
    "08 17",                                            // `
    "46 42;45 36 16 05 03 12 32 43",                    // a
    "08 02;05 16 36 45 43 32 12 03",                    // b
    "45 36 16 05 03 12 32 43",                          // c
    "48 42;45 36 16 05 03 12 32 43",                    // d
    "04 44 45 36 16 05 03 12 32 43",                    // e
    "38 28 17 12;06 36",                                // f
    "46 41 30 10 01;45 36 16 05 03 12 32 43",           // g
    "08 02;05 16 36 45 42",                             // h
    "06 02;08 08",                                      // i
    "16 11 00;18 18",                                   // j
    "08 02;36 04 32",                                   // k
    "08 02",                                            // l
    "06 02;05 16 25 22;25 36 45 42",                    // m
    "06 02;05 16 36 45 42",                             // n
    "05 16 36 45 43 32 12 03 05",                       // o
    "06 00;05 16 36 45 43 32 12 03",                    // p
    "46 40;45 36 16 05 03 12 32 43",                    // q
    "06 02;05 16 36",                                   // r
    "45 36 16 05 14 34 43 32 12 03",                    // s
    "18 13 22 32;06 36",                                // t
    "06 03 12 32 43;46 42",                             // u
    "06 22 46",                                         // v
    "06 12 25 32 46",                                   // w
    "06 42;02 46",                                      // x
    "06 22;46 22 10 00",                                // y
    "06 46 02 42",                                      // z
    "28 17 16 05 14 13 22",                             // {
    "08 00",                                            // |
    "08 17 16 25 14 13 02",                             // }
    "04 15 35 46",                                      // ~
};
constexpr int base_line = 2, capital = 6, between = 2, space = 3;  // in steps

std::string_view strokes_of(char c) {
  constexpr char first = '!', last = '~';
  const char known = c >= first && c <= last ? c : '?';
  return strokes[static_cast<std::size_t>(known - first)];
}

int width_of(char c) {
  if (c == ' ') return space;
  int width = 0;
  const std::string_view all = strokes_of(c);
  for (std::size_t i = 0; i + 1 < all.size(); i += 3) width = std::max(width, all[i] - '0');
  return width;
}

void draw_letter(canvas& on, const point& at, double step, std::string_view all) {
  for (std::size_t i = 0; i + 1 < all.size(); i += 3) {
    const point to = {at.x + step * (all[i] - '0'), at.y - step * (all[i + 1] - '0' - base_line)};
    if (i == 0 || all[i - 1] == ';')
      on.move_to(to);
    else
      on.line_to(to);
  }
}

}  // namespace

double text_width(std::string_view text, double height) {
  int steps = 0;
  for (const char c : text) steps += width_of(c) + between;
  return std::max(0, steps - between) * height / capital;
}

void draw_text(canvas& on, const point& at, double height, std::string_view text) {
  const double step = height / capital;
  double x = at.x;
  for (const char c : text) {
    if (c != ' ') draw_letter(on, {x, at.y}, step, strokes_of(c));
    x += step * (width_of(c) + between);
  }
  on.set_line_width(0.16 * height);
  on.stroke();
}

}  // namespace asterism::internal
