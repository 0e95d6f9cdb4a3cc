// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>

/// A line of this process's status in KiB; 0 where the system does not tell.
inline long status_kb(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(key, 0) == 0) return std::stol(line.substr(key.size()));
  }
  return 0;
}

/// Largest resident memory of this process so far. Unlike ru_maxrss, it does not count what the parent held when it
/// started the process.
inline long peak_kb() {
  return status_kb("VmHWM:");
}

/// Resident memory of this process now.
inline long resident_kb() {
  return status_kb("VmRSS:");
}
