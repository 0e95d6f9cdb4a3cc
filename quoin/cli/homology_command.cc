// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <variant>
#include <vector>

#include "quoin/base/error.h"
#include "quoin/cli/commands.h"
#include "quoin/cli/inputs.h"
#include "quoin/cli/planar.h"
#include "quoin/cli/primes.h"
#include "quoin/cli/summary.h"
#include "quoin/io/cells_complex.h"
#include "quoin/io/cells_text.h"
#include "quoin/io/mesh_complex.h"
#include "quoin/io/simplex_text.h"
#include "quoin/topology/homology.h"
#include "quoin/topology/manifold.h"

namespace quoin::cli {

namespace {

using Json = nlohmann::ordered_json;

// Above dimension 3 the links of all simplices have their homology computed.
constexpr std::size_t most_with_links = 4000;

void warn_of(const MeshComplex& made, bool has_faces, const std::string& name, std::vector<std::string>& warnings) {
  const auto warn = [&](std::size_t count, const char* what) {
    if (count > 0) warnings.push_back(shown(name) + ": " + std::to_string(count) + what);
  };
  if (has_faces) warn(made.lonely_vertices, " vertices are corners of no face: left out");
  warn(made.repeated_faces, " faces have the corners of others: each counts once");
  warn(made.thin_faces, " faces have fewer than three corners, where equal neighbours are one: edges or points");
}

SimplexList simplices_of(const Input& input, const std::string& name, std::vector<std::string>& warnings,
                         const Context& context) {
  const Mesh* mesh = std::get_if<Mesh>(&input);
  if (mesh == nullptr)
    throw InputError(shown(name) + ": exact text is not taken here; 'quoin convert' makes a mesh of it");
  MeshComplex made = complex_of_mesh(*mesh, context);
  warn_of(made, mesh->face_count() > 0, name, warnings);
  return std::move(made.simplices);
}

bool is_mesh_name(const std::string& name) {
  return format_from_path(name).has_value() || ending_of(name) == ".qsolid";
}

// A mesh, exact cells, or a text of simplices, which begins with a number.
SimplexList read_complex(const std::string& name, const Options& options, std::vector<std::string>& warnings,
                         const Context& context) {
  if (is_mesh_name(name)) return simplices_of(read_input(name, options, warnings, context), name, warnings, context);
  const std::string bytes = read_all(name);
  if (ending_of(name) == ".qcells" || is_cells_text(bytes))
    return simplices_of_cells(read_cells_text(bytes, shown(name), context), context).simplices;
  if (begins_like_simplices(bytes)) return read_simplices(bytes, shown(name), context);
  return simplices_of(input_of_bytes(bytes, name, options, warnings, context), name, warnings, context);
}

Json as_json(const Integer& number) {
  constexpr std::size_t bits_of_doubles = 53;
  if (number.bit_length() > bits_of_doubles) return number.to_string();
  return mpz_get_si(number.raw());
}

Json torsion_of(const IntegerHomology& homology) {
  Json torsion = Json::array();
  for (const std::vector<Integer>& orders : homology.torsion) {
    Json list = Json::array();
    for (const Integer& order : orders) list.push_back(as_json(order));
    torsion.push_back(std::move(list));
  }
  return torsion;
}

// Over the rationals, 2, the primes asked for and those of torsion. Each by itself, and as the integers have it.
Json betti_of(const OrderedBoundaries& boundaries, const IntegerHomology& homology, std::vector<std::uint32_t> primes,
              const Context& context) {
  Json betti{{"Q", homology.betti}};
  primes.push_back(2);
  for (const std::uint32_t p : torsion_primes(homology)) primes.push_back(p);
  std::sort(primes.begin(), primes.end());
  primes.erase(std::unique(primes.begin(), primes.end()), primes.end());
  for (const std::uint32_t p : primes) {
    const std::vector<std::size_t> numbers = betti_numbers(boundaries, p, context);
    if (numbers != betti_numbers(homology, p))
      throw InternalError("Betti numbers over " + std::to_string(p) + " elements contradict integer homology");
    betti["Z" + std::to_string(p)] = numbers;
  }
  return betti;
}

void add_manifold(Json& report, const SimplicialComplex& complex, const Context& context) {
  const ManifoldReport manifold = check_manifold(complex, context);
  report["manifold"] = manifold.is_manifold();
  report["closed"] = manifold.is_closed();
  const auto witness = [&](const char* what, const std::optional<SimplexId>& simplex) {
    if (simplex) report["not_manifold"][what] = complex.labels(*simplex);
  };
  witness("maximal", manifold.impure);
  witness("branching", manifold.branching);
  witness("pinched", manifold.pinched);
  const OrientationReport orientation = orient(complex, context);
  report["orientable"] = orientation.is_orientable();
  for (const std::uint32_t simplex : orientation.reversing_loop)
    report["reversing_loop"].push_back(complex.labels({complex.dimension(), simplex}));
  if (complex.dimension() != 2 || !manifold.is_manifold()) return;
  for (const SurfaceClass& part : classify_surface(complex, manifold, context)) {
    report["surfaces"].push_back({{"orientable", part.is_orientable},
                                  {"genus", part.genus},
                                  {"boundary_loops", part.boundary_loops},
                                  {"euler_characteristic", part.euler_characteristic}});
  }
}

}  // namespace

int run_homology(const Options& options, const Context& context) {
  const std::vector<std::uint32_t> primes = primes_of(options);
  std::vector<std::string> warnings;
  const std::string& name = options.inputs[0];
  const SimplicialComplex complex =
      SimplicialComplex::closure_of(read_complex(name, options, warnings, context), context);
  if (complex.dimension() < 0) throw InputError(shown(name) + ": there is no simplex");
  Json counts = Json::array();
  for (int k = 0; k <= complex.dimension(); ++k) counts.push_back(complex.count(k));
  Json report{{"dimension", complex.dimension()},
              {"simplices", std::move(counts)},
              {"euler_characteristic", complex.euler_characteristic()},
              {"components", connected_components(complex).count}};
  const OrderedBoundaries boundaries = collapsed(complex, context);
  const IntegerHomology homology = integer_homology(boundaries, context);
  report["betti"] = betti_of(boundaries, homology, primes, context);
  report["torsion"] = torsion_of(homology);
  if (complex.dimension() <= 3 || complex.size() <= most_with_links) {
    add_manifold(report, complex, context);
  } else {
    warnings.push_back(shown(name) +
                       ": whether it is a manifold was not examined: of dimension above 3 and more than " +
                       std::to_string(most_with_links) + " simplices");
  }
  const std::string text = as_text(report);
  print_report(std::move(report), text, warnings, options);
  return 0;
}

}  // namespace quoin::cli
