// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/target_writing.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "quoin/base/error.h"
#include "quoin/cli/forced_end.h"
#include "quoin/cli/interruption.h"
#include "quoin/cli/polled_output.h"
#include "quoin/cli/streams.h"

namespace quoin::cli {

namespace {

void write_blocks(std::ostream& out, const BlockBuffer& content) {
  for (std::size_t i = 0; i < content.block_count() && out; ++i) {
    poll_running();
    out << content.block(i);
  }
}

/// A file that takes the place of another, or goes.
class Replacement {
 public:
  /// Nothing is opened where the target is no ordinary file of one name: a device, a link.
  explicit Replacement(const std::string& target) : target_(target) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::symlink_status(target, error);
    const bool is_new = status.type() == std::filesystem::file_type::not_found;
    const bool is_ordinary = status.type() == std::filesystem::file_type::regular &&
                             std::filesystem::hard_link_count(target, error) == 1 && !error &&
                             access(target.c_str(), W_OK) == 0;
    if (!is_new && !is_ordinary) return;
    const std::string name = target + ".part" + std::to_string(getpid());
    {
      WithoutForcedEnd guard;
      file_.open(name, std::ios::binary | std::ios::trunc);
      if (!file_) return;
      name_ = name;
      guard.remove_at_forced_end(name_.c_str());
    }
    if (!is_new) std::filesystem::permissions(name_, status.permissions(), error);
  }
  ~Replacement() {
    if (name_.empty()) return;
    WithoutForcedEnd guard;
    std::error_code error;
    std::filesystem::remove(name_, error);
    guard.remove_at_forced_end(nullptr);
  }
  Replacement(const Replacement&) = delete;
  Replacement& operator=(const Replacement&) = delete;

  bool is_open() const { return !name_.empty(); }
  std::ostream& stream() { return file_; }

  void take_place() {
    file_.close();
    WithoutForcedEnd guard;
    std::error_code error;
    if (file_) std::filesystem::rename(name_, target_, error);
    if (!file_ || error) throw FileError(target_ + ": cannot be written");
    guard.remove_at_forced_end(nullptr);
    name_.clear();
  }

 private:
  std::string target_;
  std::string name_;  // empty when there is none
  std::ofstream file_;
};

void write_file(const std::string& name, const BlockBuffer& content) {
  Replacement replacement(name);
  if (replacement.is_open()) {
    write_blocks(replacement.stream(), content);
    replacement.take_place();
    return;
  }
  std::ofstream file(name, std::ios::binary);
  if (!file) throw FileError(name + ": cannot be opened for writing");
  write_blocks(file, content);
  file.close();
  if (!file) throw FileError(name + ": cannot be written");
}

}  // namespace

void write_target(const Target& target, const std::function<void(std::ostream&)>& write) {
  BlockBuffer content;
  std::ostream out(&content);
  out.exceptions(std::ios::badbit);  // a lack of memory is not swallowed
  write(out);
  if (!target.is_stream()) {
    write_file(target.name, content);
    return;
  }
  write_blocks(data_stream(), content);
  flush_standard_output();
}

}  // namespace quoin::cli
