// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/whole_input.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

#include "quoin/base/error.h"
#include "quoin/cli/interruption.h"
#include "quoin/cli/options.h"

namespace quoin::cli {

namespace {

class Descriptor {
 public:
  explicit Descriptor(const std::string& name)
      : number_(name == standard_stream ? STDIN_FILENO : open(name.c_str(), O_RDONLY | O_CLOEXEC)),
        is_own_(name != standard_stream) {}
  ~Descriptor() {
    if (is_own_ && number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }

 private:
  int number_;
  bool is_own_;
};

/// Until there is something to read, or the end.
void wait_for(int descriptor) {
  constexpr int milliseconds = 20;
  pollfd waiting{descriptor, POLLIN, 0};
  do {
    poll_running();
  } while (poll(&waiting, 1, milliseconds) == 0);
}

[[noreturn]] void fail(const std::string& name, const char* how, int error) {
  throw FileError(shown(name) + ": " + how + ": " + std::strerror(error));
}

}  // namespace

std::string shown(const std::string& name) {
  return name == standard_stream ? "standard input" : name;
}

std::string read_all(const std::string& name) {
  constexpr std::size_t block_size = std::size_t{1} << 18;
  const Descriptor descriptor(name);
  if (descriptor.number() < 0) fail(name, "cannot be opened", errno);
  struct stat status {};
  std::string bytes;
  if (fstat(descriptor.number(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) throw FileError(shown(name) + ": is a directory");
    if (S_ISREG(status.st_mode)) bytes.reserve(static_cast<std::size_t>(status.st_size));
  }
  const auto block = std::make_unique_for_overwrite<char[]>(block_size);
  for (;;) {
    wait_for(descriptor.number());
    const ssize_t size = read(descriptor.number(), block.get(), block_size);
    if (size == 0) return bytes;
    if (size > 0) {
      bytes.append(block.get(), static_cast<std::size_t>(size));
    } else if (errno != EINTR && errno != EAGAIN) {
      fail(name, "cannot be read", errno);
    }
  }
}

}  // namespace quoin::cli
