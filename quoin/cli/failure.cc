// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/failure.h"

#include <exception>
#include <new>

#include "quoin/cli/interruption.h"
#include "quoin/cli/memory_watch.h"
#include "quoin/cli/streams.h"

namespace quoin::cli {

Failure current_failure() {
  if (was_interrupted()) return {"cancelled", exit_cancelled};
  if (const auto refusal = memory_refusal()) return {*refusal, exit_refused};
  try {
    throw;
  } catch (const UsageError& error) {
    return {error.what(), exit_usage};
  } catch (const Cancelled& error) {
    return {error.what(), exit_cancelled};
  } catch (const FileError& error) {
    return {error.what(), exit_file};
  } catch (const std::bad_alloc&) {
    return {"out of memory", exit_refused};
  } catch (const std::exception& error) {
    return {error.what(), exit_refused};
  }
}

nlohmann::ordered_json as_json(const Failure& failure) {
  return {{"error", failure.message}, {"exit_code", failure.exit_code}};
}

void print_failure(const Failure& failure, const Options& options) {
  using Handler = nlohmann::ordered_json::error_handler_t;
  if (options.json) report_stream(options) << as_json(failure).dump(2, ' ', false, Handler::replace) << "\n";
  if (!options.json || !data_goes_to_standard_output(options))
    note_stream() << "quoin: " << printable(failure.message) << "\n";
}

}  // namespace quoin::cli
