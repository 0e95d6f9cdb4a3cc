// SPDX-License-Identifier: Apache-2.0
//
// How long a union with its exit goes on after it was cancelled, at moments spread over its duration.
//
//   cancellation_bench THREADS MOMENTS FILE...

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <thread>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/base/parallel.h"
#include "quoin/io/mesh_file.h"
#include "quoin/solid/exit.h"
#include "quoin/solid/solid.h"

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

void run(const std::vector<quoin::Mesh>& meshes, const quoin::Context& context) {
  std::vector<quoin::Solid> solids(meshes.size());
  quoin::for_each_chunk(context, meshes.size(), 1, [&](const quoin::Chunk& chunk) {
    solids[chunk.index] = quoin::Solid::of_leaf(quoin::make_leaf(meshes[chunk.index], {}, context).leaf);
  });
  quoin::triangulate_boundary(quoin::unite(solids, context).boundary(), {}, context);
}

// Seconds from the cancellation to its effect; nothing where the run had ended before.
std::optional<double> cancel_after(const std::vector<quoin::Mesh>& meshes, unsigned threads, Seconds wait) {
  quoin::Context context({.threads = threads});
  Clock::time_point cancelled;
  std::thread canceller([&] {
    std::this_thread::sleep_for(wait);
    cancelled = Clock::now();
    context.cancel();
  });
  std::optional<Clock::time_point> stopped;
  try {
    run(meshes, context);
  } catch (const quoin::Cancelled&) {
    stopped = Clock::now();
  }
  canceller.join();
  if (!stopped) return std::nullopt;
  return Seconds(*stopped - cancelled).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "cancellation_bench THREADS MOMENTS FILE...\n");
    return 2;
  }
  const auto threads = static_cast<unsigned>(std::atoi(argv[1]));
  const int moments = std::atoi(argv[2]);
  const quoin::Context context({.threads = threads});
  std::vector<quoin::Mesh> meshes;
  for (int i = 3; i < argc; ++i) meshes.push_back(quoin::read_mesh(std::filesystem::path(argv[i]), {}, context).mesh);
  const Clock::time_point start = Clock::now();
  run(meshes, context);
  const Seconds whole = Clock::now() - start;
  double worst = 0;
  int stopped = 0;
  for (int m = 0; m < moments; ++m) {
    const std::optional<double> latency = cancel_after(meshes, threads, whole * (m + 0.5) / moments);
    if (!latency) continue;
    ++stopped;
    worst = std::max(worst, *latency);
  }
  std::printf("{\"seconds\": %.6f, \"stopped\": %d, \"worst\": %.6f}\n", whole.count(), stopped, worst);
}
