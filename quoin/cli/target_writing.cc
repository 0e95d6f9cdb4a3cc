// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/target_writing.h"

#include <fstream>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/cli/streams.h"

namespace quoin::cli {

void write_target(const Target& target, const std::function<void(std::ostream&)>& write) {
  std::ostringstream content;
  content.exceptions(std::ios::badbit);  // a lack of memory is not swallowed
  write(content);
  if (target.is_stream()) {
    data_stream() << content.view();
    flush_standard_output();
    return;
  }
  std::ofstream file(target.name, std::ios::binary);
  if (!file) throw FileError(target.name + ": cannot be opened for writing");
  file << content.view();
  file.close();
  if (!file) throw FileError(target.name + ": cannot be written");
}

}  // namespace quoin::cli
