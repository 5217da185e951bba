// SPDX-License-Identifier: MIT
//
// Runs the fuzzer's target on every file of the folders named, without a fuzzer. Exit status 2
// when there is none.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerInitialize(int*, char***);
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::vector<std::filesystem::path> files_of(int count, char** folders) {
  std::vector<std::filesystem::path> files;
  for (int k = 0; k < count; ++k)
    for (const auto& entry : std::filesystem::directory_iterator(folders[k]))
      if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

int main(int argc, char** argv) try {
  (void)LLVMFuzzerInitialize(&argc, &argv);
  const auto files = files_of(argc - 1, argv + 1);
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    const std::vector<std::uint8_t> data(bytes.begin(), bytes.end());
    (void)LLVMFuzzerTestOneInput(data.data(), data.size());
  }
  (void)std::printf("%zu files, no difference\n", files.size());
  return files.empty() ? 2 : 0;
} catch (const std::exception& failure) {
  (void)std::fprintf(stderr, "replay_corpus: %s\n", failure.what());
  return 2;
}
