// SPDX-License-Identifier: MIT
//
// The fuzzer's target for readers of files. The first byte chooses the reader, the rest is the
// file. It aborts when a reader refuses a file without a sentence that a terminal can show, or
// when what was read is not what a writer gives back. Sanitizers tell the rest. The environment
// variable ASTERISM_FUZZ_COUNTS names a file that gets the numbers of files read and refused, per
// reader.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "asterism/core/floating_point_environment.hpp"
#include "asterism/mesh/audit/certificate.hpp"
#include "asterism/mesh/domain/check_domain.hpp"
#include "asterism/mesh/io/load_domain.hpp"
#include "asterism/mesh/io/read_mesh.hpp"
#include "asterism/mesh/io/solution_file.hpp"
#include "asterism/mesh/io/write_mesh.hpp"
#include "asterism/mesh/metric/expression_enclosure.hpp"
#include "asterism/mesh/metric/plane_expression.hpp"

namespace {

using namespace asterism;
using std::filesystem::path;

// Largest size of a domain that is checked: beyond it the checks, quadratic in the worst case, take
// longer than the reader.
constexpr std::size_t most_segments = 300;

[[noreturn]] void give_up(const std::string& what) {
  (void)std::fprintf(stderr, "fuzz_readers: %s\n", what.c_str());
  std::abort();
}

// A folder, in memory where possible, that is removed at the end.
class folder_of_files {
 public:
  folder_of_files() {
    const path base = std::filesystem::exists("/dev/shm") ? path("/dev/shm")
                                                          : std::filesystem::temp_directory_path();
    folder_ = base / ("asterism-fuzz-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  folder_of_files(const folder_of_files&) = delete;
  folder_of_files& operator=(const folder_of_files&) = delete;
  ~folder_of_files() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  path of(std::string_view name) const { return folder_ / name; }
  path write(std::string_view name, std::string_view bytes) const {
    std::ofstream out(of(name), std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return of(name);
  }

 private:
  path folder_;
};

const folder_of_files& files() {
  static const folder_of_files made;
  return made;
}

// True if the reader accepted the text; checks the message of a refusal.
template <class Value>
bool is_read(const result<Value>& got) {
  if (got) return true;
  const std::string& said = got.failure().message;
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (said.empty() || std::any_of(said.begin(), said.end(), is_control))
    give_up("a refusal that cannot be shown: " + said);
  return false;
}

bool same(double a, double b) { return a == b; }
bool same(const site& a, const site& b) {
  return same(a.position.x, b.position.x) && same(a.position.y, b.position.y) &&
         same(a.metric.m11, b.metric.m11) && same(a.metric.m12, b.metric.m12) &&
         same(a.metric.m22, b.metric.m22);
}

// Returns a mesh of four vertices and two triangles, on which solutions and metrics are read.
mesh small_mesh() {
  mesh m;
  for (const point p : {point{0, 0}, point{1, 0}, point{1, 1}, point{0, 1}})
    m.sites.push_back({p, {1, 0, 1}});
  m.given = 4;
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (vertex_index k = 0; k < 4; ++k) m.boundary.push_back({k, (k + 1) % 4, k, 1});
  return m;
}

bool read_a_domain(const path& file) {
  const auto read = load_domain(file.string());
  if (!is_read(read)) return false;
  if (read.value().segments.size() <= most_segments &&
      read.value().vertices.size() <= most_segments)
    (void)is_read(check_domain(read.value()));
  return true;
}

void expect_same(const mesh& m, const mesh& other, const path& to) {
  if (!std::equal(m.sites.begin(), m.sites.end(), other.sites.begin(), other.sites.end(),
                  [](const site& a, const site& b) { return same(a, b); }))
    give_up("other sites are read from " + to.string());
  if (m.triangles != other.triangles) give_up("other triangles are read from " + to.string());
}

mesh written_and_read(const mesh& m, const path& to) {
  if (!write_mesh(to, m)) give_up("what was read cannot be written to " + to.string());
  auto again = read_mesh(to);
  if (!again) give_up("what was written cannot be read: " + again.failure().message);
  return std::move(again.value());
}

// Checks that a mesh in order is the same after writing and reading, in every format. A text file
// in the project's own format, which is only listed, comes back as listed.
void expect_again(const mesh& m, const path& to) { expect_same(m, written_and_read(m, to), to); }

std::string text_of(const path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool is_own(const path& file) { return text_of(file).find("segments") != std::string::npos; }

bool read_a_mesh(const path& file) {
  medit_read_options options;
  options.identity_without_solution = true;
  const auto read = read_mesh(file, options);
  (void)read_medit_marks(file);
  (void)names_in(file);
  if (!is_read(read)) return false;
  // Reads edges without triangles as a domain.
  if (read.value().triangles.empty()) return true;
  expect_again(read.value(), files().of("again.mesh"));
  if (is_own(file)) return true;
  for (const char* name : {"again.meshb", "again.msh", "again.msh2", "again.vtu"})
    expect_again(read.value(), files().of(name));
  return true;
}

bool read_a_metric(const path& file) {
  medit_read_options options;
  options.solution = file;
  static const path four = [] {
    (void)write_mesh(files().of("four.mesh"), small_mesh());
    return files().of("four.mesh");
  }();
  return is_read(read_mesh(four, options));
}

bool read_a_solution(const path& file) {
  static const mesh four = small_mesh();
  const auto read = read_solution(file, four);
  if (!is_read(read)) return false;
  for (const char* name : {"values.sol", "values.solb"}) {
    if (!write_solution(files().of(name), read.value()))
      give_up(std::string("what was read cannot be written to ") + name);
    const auto again = read_solution(files().of(name), four);
    if (!again) give_up("what was written cannot be read: " + again.failure().message);
    const auto& fields = read.value().fields;
    const auto& others = again.value().fields;
    if (!std::equal(fields.begin(), fields.end(), others.begin(), others.end(),
                    [](const solution_field& a, const solution_field& b) {
                      return a.kind == b.kind && a.values == b.values;
                    }))
      give_up(std::string("other values are read from ") + name);
  }
  return true;
}

bool read_a_certificate(const path& file) {
  const auto read = read_certificate(file);
  if (!is_read(read)) return false;
  const auto again = parse_certificate(certificate_text(read.value()), "again");
  if (!again) give_up("a certificate written cannot be read: " + again.failure().message);
  return true;
}

bool are_apart(const internal::rounded_interval& a, const internal::rounded_interval& b) {
  return a.inf() > b.sup() || b.inf() > a.sup();
}

// Checks that the enclosure at a point where the formula has a value meets the one over a box
// around it, since both contain the value and its derivatives.
void expect_enclosures_meet(const internal::expression_enclosure& enclosed, const point& q,
                            const std::string& text) {
  const internal::floating_point_scope scope(internal::rounding::upward);
  const double width = 0.4 * (1 + std::abs(q.x));
  const auto at = enclosed.over(internal::coordinates_over({q.x, q.x}, {q.y, q.y}));
  const auto around =
      enclosed.over(internal::coordinates_over({q.x - width, q.x + 1}, {q.y - 0.1, q.y + width}));
  if (are_apart(at.value, around.value) || are_apart(at.x, around.x) || are_apart(at.y, around.y))
    give_up("enclosures of a value do not meet: " + text);
}

// Reads a file as a formula in x and y.
bool read_a_formula(const path& file) {
  const std::string text = text_of(file);
  const auto read = internal::plane_expression::parse(text);
  const auto enclosed = internal::expression_enclosure::parse(text);
  if (!read && (enclosed || read.failure().message.empty()))
    give_up("a formula that is refused, without a word or enclosed: " + text);
  if (!enclosed) return read.ok();
  for (const point q : {point{0, 0}, point{0.3, -0.7}, point{-1000, 1e-8}})
    if (std::isfinite(read.value()(q))) expect_enclosures_meet(*enclosed, q, text);
  return true;
}

struct reader {
  const char* name;  // stems differ: the metric of a mesh lies beside it
  bool (*read)(const path&);
  unsigned long long taken = 0, refused = 0;
};

std::array<reader, 24> readers{{{"a.poly", read_a_domain},
                                {"b.geojson", read_a_domain},
                                {"c.wkt", read_a_domain},
                                {"d.mesh", read_a_mesh},
                                {"e.meshb", read_a_mesh},
                                {"f.msh", read_a_mesh},
                                {"g.sol", read_a_metric},
                                {"h.solb", read_a_metric},
                                {"i.mtr", read_a_metric},
                                {"j.sol", read_a_solution},
                                {"k.solb", read_a_solution},
                                {"l.bb", read_a_solution},
                                {"m.BB", read_a_solution},
                                {"n.vtu", read_a_solution},
                                {"o.certificate.json", read_a_certificate},
                                {"p.vtu", read_a_mesh},
                                {"q.su2", read_a_mesh},
                                {"r.14", read_a_mesh},
                                {"s.2dm", read_a_mesh},
                                {"t.vtk", read_a_mesh},
                                {"u.stl", read_a_mesh},
                                {"v.node", read_a_domain},
                                {"w.mesh", read_a_domain},
                                {"x.formula", read_a_formula}}};

void write_counts() {
  const char* const name = std::getenv("ASTERISM_FUZZ_COUNTS");
  std::FILE* const out = name != nullptr ? std::fopen(name, "w") : nullptr;
  if (out == nullptr) return;
  for (const reader& r : readers)
    (void)std::fprintf(out, "%-20s read %10llu refused %10llu\n", r.name, r.taken, r.refused);
  (void)std::fclose(out);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  (void)std::atexit(write_counts);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0 || data[0] < 'a' || data[0] >= 'a' + readers.size()) return 0;
  reader& asked = readers[data[0] - 'a'];
  const std::string_view content(reinterpret_cast<const char*>(data) + 1, size - 1);
  const bool taken = asked.read(files().write(asked.name, content));
  ++(taken ? asked.taken : asked.refused);
  return 0;
}
