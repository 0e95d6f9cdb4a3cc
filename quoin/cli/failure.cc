// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/failure.h"

#include <exception>
#include <new>
#include <system_error>

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
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) return {error.what(), exit_refused};
    return {"cannot start a thread: " + error.code().message() + "; there is too little memory or too many threads",
            exit_refused};
  } catch (const std::exception& error) {
    return {error.what(), exit_refused};
  }
}

nlohmann::ordered_json as_json(const Failure& failure) {
  return {{"error", failure.message}, {"exit_code", failure.exit_code}};
}

LastWords words_of(const Failure& failure, const Options& options) {
  using Handler = nlohmann::ordered_json::error_handler_t;
  const bool is_data_on_output = data_goes_to_standard_output(options);
  LastWords words;
  if (options.json) {
    std::string& report = is_data_on_output ? words.error : words.output;
    report = as_json(failure).dump(2, ' ', false, Handler::replace) + "\n";
  }
  if (!options.json || !is_data_on_output) words.error = "quoin: " + printable(failure.message) + "\n";
  return words;
}

void print_failure(const Failure& failure, const Options& options) {
  const LastWords words = words_of(failure, options);
  if (!words.output.empty()) report_stream(options) << words.output;
  note_stream() << words.error;
}

}  // namespace quoin::cli
