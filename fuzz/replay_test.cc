// SPDX-License-Identifier: Apache-2.0
//
// Every seed and every case that a fuzz target ever failed on, in the ordinary build.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "fuzz/targets.h"
#include "quoin/base/test_rounds.h"
#include "quoin/io/mesh_file.h"

namespace quoin::fuzz {
namespace {

std::vector<std::filesystem::path> files_of(std::string_view target) {
  std::vector<std::filesystem::path> files;
  for (const char* kind : {"seeds", "found"}) {
    const std::filesystem::path folder = std::filesystem::path(QUOIN_FUZZ_DIR) / kind / target;
    if (!std::filesystem::exists(folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void run(const NamedTarget& target, const std::string& text) {
  target.run({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Replay, SeedsAndFoundCases) {
  for (const NamedTarget& target : targets) {
    for (const std::filesystem::path& file : files_of(target.name)) {
      SCOPED_TRACE(file.string());
      run(target, read_file(file));
    }
  }
}

// Seeds with bytes changed, cut short and put twice.
TEST(Replay, DamagedSeeds) {
  std::mt19937 random(11);
  for (const NamedTarget& target : targets) {
    for (const std::filesystem::path& file : files_of(target.name)) {
      SCOPED_TRACE(file.string());
      const std::string whole = read_file(file);
      for (int i = 0; i < test_rounds(60) && !whole.empty(); ++i) {
        std::string text = whole;
        for (std::size_t k = random() % 4; k > 0; --k) text[random() % text.size()] = static_cast<char>(random());
        if (random() % 3 == 0) text.resize(random() % text.size());
        if (random() % 5 == 0) text += whole;
        run(target, text);
      }
    }
  }
}

TEST(Replay, RandomBytes) {
  std::mt19937 random(5);
  for (const NamedTarget& target : targets) {
    for (int i = 0; i < test_rounds(300); ++i) {
      std::string text(random() % 64, ' ');
      for (char& c : text) c = static_cast<char>(random());
      run(target, text);
    }
  }
}

}  // namespace
}  // namespace quoin::fuzz
