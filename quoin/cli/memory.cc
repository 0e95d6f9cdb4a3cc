// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "quoin/base/error.h"
#include "quoin/cli/streams.h"

namespace quoin::cli {

namespace {

constexpr std::uint64_t worth_a_word = 1'000'000'000;

std::uint64_t page_size() {
  return static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// The number in a file that holds one, as control groups have; nothing for "max".
std::optional<std::uint64_t> number_in(const char* file) {
  std::ifstream in(file);
  std::uint64_t value = 0;
  if (in >> value) return value;
  return std::nullopt;
}

/// The number behind a name at the beginning of a line.
std::optional<std::uint64_t> number_of(std::string_view name, const char* file) {
  std::ifstream in(file);
  std::string key;
  std::uint64_t value = 0;
  std::string unit;
  while (in >> key >> value) {
    if (key == name) return value;
    std::getline(in, unit);
  }
  return std::nullopt;
}

std::optional<std::uint64_t> free_of_machine() {
  const auto kilobytes = number_of("MemAvailable:", "/proc/meminfo");
  return kilobytes ? std::optional(*kilobytes * 1024) : std::nullopt;
}

std::optional<std::uint64_t> free_of_process() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return std::nullopt;
  std::ifstream in("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!(in >> pages)) return std::nullopt;
  return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, pages * page_size());
}

std::optional<std::uint64_t> free_of_group() {
  const auto most = number_in("/sys/fs/cgroup/memory.max");
  const auto taken = number_in("/sys/fs/cgroup/memory.current");
  if (!most || !taken) return std::nullopt;
  // Files that were read lately count as taken, and make room when it is wanted.
  const std::uint64_t files = number_of("inactive_file", "/sys/fs/cgroup/memory.stat").value_or(0);
  return *most - std::min(*most, *taken - std::min(*taken, files));
}

}  // namespace

std::string in_megabytes(std::uint64_t bytes) {
  return std::to_string(static_cast<std::uint64_t>(static_cast<double>(bytes) / megabyte) + 1) + " MB";
}

std::optional<std::uint64_t> available_memory() {
  std::optional<std::uint64_t> least;
  for (const auto& free : {free_of_machine(), free_of_process(), free_of_group()}) {
    if (free) least = std::min(least.value_or(*free), *free);
  }
  return least;
}

std::optional<std::uint64_t> swap_memory() {
  const auto kilobytes = number_of("SwapFree:", "/proc/meminfo");
  return kilobytes ? std::optional(*kilobytes * 1024) : std::nullopt;
}

std::optional<std::uint64_t> own_memory() {
  std::ifstream in("/proc/self/statm");
  std::uint64_t all = 0;
  std::uint64_t resident = 0;
  std::uint64_t of_files = 0;
  if (!(in >> all >> resident >> of_files)) return std::nullopt;
  return (resident - std::min(resident, of_files)) * page_size();
}

void announce_memory(std::uint64_t bytes, std::size_t points, const Options& options) {
  const std::string need = std::to_string(points) + " points need about " + in_megabytes(bytes) + " of memory";
  if (options.memory && static_cast<double>(bytes) > *options.memory * megabyte)
    throw InputError(need + ", more than --memory allows; nothing was begun");
  const auto available = available_memory();
  if (!options.memory && available && bytes > *available) {
    throw InputError(need + ", and " + in_megabytes(*available) +
                     " are free; nothing was begun ('--memory MB' sets another limit)");
  }
  if (bytes >= worth_a_word && !options.quiet) note_stream() << "quoin: " << need << std::endl;
}

}  // namespace quoin::cli
