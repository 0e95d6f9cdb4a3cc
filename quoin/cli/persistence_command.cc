// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/persistence_diagram.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/primes.h"
#include "quoin/io/cells_complex.h"
#include "quoin/io/cells_text.h"
#include "quoin/io/simplex_text.h"
#include "quoin/topology/persistence.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Nearest doubles, the largest ones for what is beyond; exact ones are told if some are no doubles.
GradeValues values_of(const std::vector<Rational>& values, const Context& context) {
  const auto rounded = [&values](std::uint32_t grade) {
    return std::clamp(values[grade].to_double(), std::numeric_limits<double>::lowest(),
                      std::numeric_limits<double>::max());
  };
  bool are_doubles = true;
  for (std::uint32_t grade = 0; grade < values.size() && are_doubles; ++grade) {
    if (grade % 1024 == 0) context.poll();
    are_doubles = Rational(rounded(grade)) == values[grade];
  }
  return {rounded, [&values](std::uint32_t grade) { return values[grade].to_string(); }, !are_doubles};
}

// Of exact cells with values, told by the ending or the first word, or of simplices.
FiltrationText read_text(const std::string& name, const Context& context) {
  const std::string bytes = read_all(name);
  if (ending_of(name) != ".qcells" && !is_cells_text(bytes)) return read_filtration(bytes, shown(name), context);
  return filtration_of_cells(read_cells_text(bytes, shown(name), context), shown(name), context);
}

Filtration filtration_of_text(const FiltrationText& text, const std::string& name, const Context& context) {
  try {
    return filtration_of(text.simplices, text.grades, context);
  } catch (const InputError& error) {
    throw InputError(shown(name) + ": " + error.what());
  }
}

}  // namespace

int run_persistence(const Options& options, const Context& context) {
  const PersistenceOptions how{.prime = prime_of(options)};
  const std::string& name = options.inputs[0];
  std::vector<std::string> warnings;
  const FiltrationText text = read_text(name, context);
  const Filtration filtration = filtration_of_text(text, name, context);
  if (filtration.added_faces > 0) {
    warnings.push_back(shown(name) + ": " + std::to_string(filtration.added_faces) +
                       " faces are not listed: each enters with the first simplex that has it");
  }
  const PersistenceDiagram diagram(filtration, values_of(text.values, context), persistence(filtration, how, context),
                                   context);
  diagram.write(options);
  Json counts = Json::array();
  for (int k = 0; k <= filtration.complex.dimension(); ++k) counts.push_back(filtration.complex.count(k));
  Json report{{"simplices", std::move(counts)}, {"prime", how.prime}};
  diagram.add_to(report, options.json);
  print_report(std::move(report), options.json || options.quiet ? "" : diagram.text(options.verbose), warnings,
               options);
  return 0;
}

}  // namespace quoin::cli
