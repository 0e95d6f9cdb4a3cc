// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/proximity_report.h"

#include <cmath>

namespace quoin::cli {

using Json = nlohmann::ordered_json;

const char* name_of(Proximity relation) {
  switch (relation) {
    case Proximity::touching:
      return "touching";
    case Proximity::overlapping:
      return "overlapping";
    case Proximity::apart:
      break;
  }
  return "apart";
}

Proximity proximity_of(Interference relation) {
  switch (relation) {
    case Interference::touching:
      return Proximity::touching;
    case Interference::overlapping:
      return Proximity::overlapping;
    case Interference::apart:
      break;
  }
  return Proximity::apart;
}

Json as_json(const RationalPoint3& p) {
  return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}
Json as_exact_json(const RationalPoint3& p) {
  return {p.x.to_string(), p.y.to_string(), p.z.to_string()};
}

Json describe_distance(Proximity relation, const Rational& squared_distance,
                       const std::array<RationalPoint3, 2>& witness) {
  Json json{{"relation", name_of(relation)},
            {"squared_distance", squared_distance.to_double()},
            {"exact_squared_distance", squared_distance.to_string()},
            {"distance", std::sqrt(squared_distance.to_double())}};
  if (relation == Proximity::overlapping) return json;
  json["witness"] = {as_json(witness[0]), as_json(witness[1])};
  json["exact_witness"] = {as_exact_json(witness[0]), as_exact_json(witness[1])};
  return json;
}

Json describe_contact(const ProximityQueries& queries, const TranslationFeature& feature) {
  Json kinds = Json::array();
  for (const auto& face : queries.faces_of(feature)) {
    kinds.push_back(face.size() == 1 ? "vertex" : face.size() == 2 ? "edge" : "face");
  }
  return {{"contact", std::move(kinds)}, {"grazing", feature.dimension < 2}};
}

}  // namespace quoin::cli
