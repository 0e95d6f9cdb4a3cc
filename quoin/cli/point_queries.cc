// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/point_queries.h"

#include <sstream>
#include <utility>

#include "quoin/cli/coordinates.h"
#include "quoin/cli/inputs.h"

namespace quoin::cli {

std::vector<Query> point_queries(const Options& options, std::size_t dimensions) {
  std::vector<Query> queries;
  for (const std::string& text : options.points) {
    queries.push_back({text, parse_argument(text, dimensions, "--point")});
  }
  if (options.points_file.empty()) return queries;
  const std::vector<Query> of_file = points_of_file(options.points_file, dimensions);
  queries.insert(queries.end(), of_file.begin(), of_file.end());
  return queries;
}

std::vector<Query> points_of_file(const std::string& name, std::size_t dimensions) {
  std::vector<Query> queries;
  std::istringstream in(read_all(name));
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    if (line.find_first_not_of(" \t") == std::string::npos || line[0] == '#') continue;
    std::vector<Rational> numbers = parse_coordinates(line, dimensions, shown(name) + ":" + std::to_string(number));
    queries.push_back({line, std::move(numbers)});
  }
  return queries;
}

}  // namespace quoin::cli
