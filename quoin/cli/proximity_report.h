// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "quoin/kernel/rational_point.h"
#include "quoin/polytope/proximity_queries.h"
#include "quoin/solid/query/distance.h"

namespace quoin::cli {

/// "apart", "touching" or "overlapping".
const char* name_of(Proximity relation);
Proximity proximity_of(Interference relation);

nlohmann::ordered_json as_json(const RationalPoint3& p);        ///< rounded
nlohmann::ordered_json as_exact_json(const RationalPoint3& p);  ///< in rationals

/// relation, squared_distance, exact_squared_distance and distance; witness and exact_witness unless they overlap.
nlohmann::ordered_json describe_distance(Proximity relation, const Rational& squared_distance,
                                         const std::array<RationalPoint3, 2>& witness);

/// Of polytopes that touch: contact, the kind of the face of each ("vertex", "edge", "face") that makes up the feature
/// of contact; and grazing, whether that is an edge or a vertex of the body of translations, which small motions in the
/// plane of contact leave.
nlohmann::ordered_json describe_contact(const ProximityQueries& queries, const TranslationFeature& feature);

}  // namespace quoin::cli
