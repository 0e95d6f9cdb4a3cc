// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <string>

/// A number of KiB from the status of this process; 0 where the system does not tell.
inline long status_kb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(name + ":", 0) == 0) return std::stol(line.substr(name.size() + 1));
  }
  return 0;
}

/// Resident memory of this process now.
inline long resident_kb() {
  return status_kb("VmRSS");
}

/// Largest resident memory of this process so far, in KiB; 0 where the system does not tell. Unlike ru_maxrss, it does
/// not count what the parent held when it started the process.
inline long peak_kb() {
  return status_kb("VmHWM");
}
