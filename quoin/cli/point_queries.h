// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "quoin/cli/options.h"
#include "quoin/number/rational.h"

namespace quoin::cli {

/// A query as it was given, and its numbers.
struct Query {
  std::string text;
  std::vector<Rational> numbers;
};

/// The points of --point and of the file of --points, a point per line, blank lines and those from '#' left out.
/// @throws UsageError  an argument is no point; InputError, FileError  the file
std::vector<Query> point_queries(const Options& options, std::size_t dimensions);

/// Those of a file, or of standard input for "-". @throws InputError, FileError
std::vector<Query> points_of_file(const std::string& name, std::size_t dimensions);

}  // namespace quoin::cli
