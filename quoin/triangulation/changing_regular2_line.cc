// SPDX-License-Identifier: Apache-2.0
// Dimension 0 and 1: the vertices are the lower hull of lifted points of a line, in order.
#include <algorithm>
#include <array>
#include <utility>

#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/changing_regular2.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = Vertex2::none_value;
constexpr std::size_t poll_step = 256;

}  // namespace

void ChangingRegular2::insert_on_line(Vertex2 v, const Context& context) {
  const WeightedPoint2& p = point(v);
  if (line_.size() > 1 && orientation(place(line_.front()), place(line_.back()), p.point) != Sign::zero) {
    const std::array<std::uint32_t, 1> all{on_line};
    build_over_line(line_, v, held_by(all, context), context);
    return;
  }
  const auto precedes = [&](Vertex2 u, const Point2& q) { return lexicographically_less(place(u), q); };
  std::size_t asked = 0;
  const auto seen = [&](Vertex2 a, Vertex2 b, Vertex2 c) {
    if (++asked % poll_step == 0) context.poll();
    return is_seen_between(point(a), point(b), point(c));
  };
  // Vertices from `first` to before `last` will be hidden.
  auto first = std::lower_bound(line_.cbegin(), line_.cend(), p.point, precedes);
  auto last = first;
  const bool is_at_vertex = first != line_.cend() && place(*first) == p.point;
  const bool is_between = first != line_.cbegin() && first != line_.cend();
  if (is_at_vertex ? p.weight < point(*first).weight : is_between && !seen(*(first - 1), v, *first)) {
    hidden_.put(v.value, on_line);
    return;
  }
  if (is_at_vertex) ++last;
  while (first - line_.cbegin() > 1 && !seen(*(first - 2), *(first - 1), v)) --first;
  while (line_.cend() - last > 1 && !seen(v, *last, *(last + 1))) ++last;
  std::vector<Vertex2> line(line_.cbegin(), first);
  line.push_back(v);
  line.insert(line.end(), last, line_.cend());
  std::for_each(first, last, [&](Vertex2 u) { hidden_.put(u.value, on_line); });
  set_line(std::move(line));
}

void ChangingRegular2::set_line(std::vector<Vertex2> line) {
  line_ = std::move(line);
  dimension_ = std::min<int>(static_cast<int>(line_.size()), 2) - 1;
}

// Hidden points between the neighbours of the vertex at this place of the line, the heaviest of each place first.
std::vector<Vertex2> ChangingRegular2::revealed_between(std::size_t at, const Context& context) const {
  const bool is_first = at == 0;
  const bool is_last = at + 1 == line_.size();
  std::vector<Vertex2> between;
  std::size_t visited = 0;
  for (std::uint32_t id = hidden_.first(on_line); id != none; id = hidden_.next(id)) {
    if (visited++ % poll_step == 0) context.poll();
    const Vertex2 v(std::size_t{id});
    const bool is_after = is_first || lexicographically_less(place(line_[at - 1]), place(v));
    const bool is_before = is_last || lexicographically_less(place(v), place(line_[at + 1]));
    if (is_after && is_before) between.push_back(v);
  }
  std::sort(between.begin(), between.end(), [&](Vertex2 a, Vertex2 b) {
    return place(a) == place(b) ? point(a).weight > point(b).weight : lexicographically_less(place(a), place(b));
  });
  return between;
}

// The lower hull between the neighbours (Andrew 1979).
void ChangingRegular2::remove_from_line(Vertex2 v, const Context& context) {
  const auto precedes = [&](Vertex2 a, Vertex2 b) { return lexicographically_less(place(a), place(b)); };
  const auto gone = std::lower_bound(line_.cbegin(), line_.cend(), v, precedes);
  const auto at = static_cast<std::size_t>(gone - line_.cbegin());
  std::vector<Vertex2> candidates = revealed_between(at, context);
  const auto is_at_one_place = [&](Vertex2 a, Vertex2 b) { return place(a) == place(b); };
  candidates.erase(std::unique(candidates.begin(), candidates.end(), is_at_one_place), candidates.end());
  const std::size_t found = candidates.size();
  if (gone + 1 != line_.cend()) candidates.push_back(*(gone + 1));
  std::vector<Vertex2> line(line_.cbegin(), gone);
  const std::size_t stays = std::max<std::size_t>(at, 1);
  std::size_t pushed = 0;
  for (const Vertex2 next : candidates) {
    if (++pushed % poll_step == 0) context.poll();
    while (line.size() > stays && !is_seen_between(point(line[line.size() - 2]), point(line.back()), point(next))) {
      line.pop_back();
    }
    line.push_back(next);
  }
  const std::size_t revealed_end = line.size() - (candidates.size() - found);
  if (gone + 1 != line_.cend()) line.insert(line.end(), gone + 2, line_.cend());
  for (std::size_t i = at; i < revealed_end; ++i) hidden_.take(line[i].value);
  set_line(std::move(line));
}

}  // namespace quoin
