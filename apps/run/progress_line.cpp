// SPDX-License-Identifier: MIT
#include "asterism/apps/run/progress_line.hpp"

#include <unistd.h>

#include <iostream>
#include <string>

namespace asterism::apps {
namespace {

constexpr const char* wipe = "\r\033[K";

// Estimates the remaining time of a fill, which adds sites at an even rate; the time of mending
// cannot be estimated.
std::string time_left(const mesh_progress& progress, double seconds) {
  const auto sites = static_cast<double>(progress.sites);
  if (seconds < 1 || sites < 1 || progress.sites_expected <= sites) return "";
  const double left = seconds * (progress.sites_expected / sites - 1);
  if (left < 90) return ", about " + std::to_string(static_cast<long>(left + 1)) + " s left";
  return left < 5400 ? ", about " + std::to_string(static_cast<long>(left / 60 + 1)) + " min left"
                     : ", hours left";
}

}  // namespace

progress_line::progress_line(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

progress_line::~progress_line() { clear(); }

void progress_line::clear() {
  if (shown_) std::cerr << wipe << std::flush;
}

void progress_line::show(const mesh_progress& progress) {
  if (!shown_) return;
  if (progress.phase == mesh_phase::auditing) {
    std::cerr << wipe << "auditing" << std::flush;
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  const double seconds = std::chrono::duration<double>(now - start_).count();
  std::cerr << wipe << progress.sites << " sites";
  if (progress.sites_expected > static_cast<double>(progress.sites))
    std::cerr << " of about " << static_cast<long>(progress.sites_expected);
  if (seconds > 1)
    std::cerr << " (" << static_cast<long>(static_cast<double>(progress.sites) / seconds)
              << " a second)";
  if (progress.phase == mesh_phase::filling) {
    std::cerr << ", filling" << time_left(progress, seconds) << std::flush;
    return;
  }
  std::cerr << ", " << progress.disagreeing << " disagreeing, " << progress.low_angle
            << " low-angle";
  if (progress.too_large > 0) std::cerr << ", " << progress.too_large << " too large";
  std::cerr << " triangles left" << std::flush;
}

}  // namespace asterism::apps
