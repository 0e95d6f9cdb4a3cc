// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>

/// Largest resident memory of this process so far, in KiB; 0 where the system does not tell. Unlike ru_maxrss, it does
/// not count what the parent held when it started the process.
inline long peak_kb() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) == 0) return std::stol(line.substr(6));
  }
  return 0;
}
