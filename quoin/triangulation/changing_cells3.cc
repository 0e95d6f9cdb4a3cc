// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_cells3.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/triangulation/flat_cells.h"
#include "quoin/triangulation/hidden_lists.h"
#include "quoin/triangulation/incremental3.h"
#include "quoin/triangulation/star_filling3.h"

namespace quoin {

template <class Signs>
struct ChangingCells3<Signs>::State {
  using Engine = IncrementalTriangulation<Signs>;

  Signs signs;
  CellArray cells;
  std::vector<std::uint32_t> star;  ///< a cell of each vertex, and that of each hidden point
  HiddenLists hidden;               ///< where signs may hide: for all ids and cells
  std::uint32_t ghost = 0;
  Engine engine{signs, cells};
  StarFilling3<Signs> filling{signs};
  std::vector<std::uint32_t> places;

  State(CellArray from, std::vector<std::uint32_t> star_of, HiddenLists hidden_of)
      : cells(std::move(from)), star(std::move(star_of)), hidden(std::move(hidden_of)) {
    reserve_lists(star.size(), cells.size());
    for (std::uint32_t c = 0; c < cells.size(); ++c) update_star(c);
  }

  void update_star(std::uint32_t c) {
    for (const std::uint32_t v : cells[c].vertices) (v == vertex_at_infinity ? ghost : star[v]) = c;
  }

  void make_room(std::uint32_t v) {
    if (v < star.size()) return;
    const std::size_t size = std::size_t{v} + 1;
    if (size > star.capacity()) star.reserve(std::max(size, 2 * star.capacity()));
    reserve_lists(size, cells.size());
    star.resize(size);
  }

  void reserve_lists(std::size_t id_count, std::size_t cell_count) {
    if constexpr (Signs::may_hide) hidden.reserve(id_count, cell_count);
  }

  /// The last cell takes the place; hidden points of the one that goes are in no list.
  void drop(std::uint32_t c) {
    const auto last = static_cast<std::uint32_t>(cells.size() - 1);
    if (c != last) {
      cells[c] = cells[last];
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t mate = cells[c].neighbours[i];
        cells[mate >> 2].neighbours[mate & 3] = c * 4 + i;
      }
      update_star(c);
      if constexpr (Signs::may_hide) move_hidden(last, c);
    }
    cells.pop_back();
  }

  void move_hidden(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t v = hidden.first(from); v != HiddenLists::none; v = hidden.next(v)) star[v] = to;
    hidden.move(from, to);
  }

  void find_conflicts(std::uint32_t v, std::uint32_t found, const Context& context) {
    engine.find_conflicts_at(found, v, PollingRegion(context));
    try {
      reserve_lists(star.size(), cells.size() + engine.facets().size());
    } catch (...) {
      engine.close();
      throw;
    }
  }

  /// For what fills the star: the places of the star, and more at the end of the array. All memory that it takes.
  void find_places() {
    places.assign(filling.star().begin(), filling.star().end());
    if (filling.size() <= places.size()) return;
    const std::size_t size = cells.size() + filling.size() - places.size();
    if (size > Engine::most_cells) throw InputError("the triangulation has more than 2^30 cells");
    places.reserve(filling.size());
    reserve_lists(star.size(), size);
    if (size > cells.capacity()) cells.reserve(std::max(size, 2 * cells.capacity()));
    while (cells.size() < size) {
      places.push_back(static_cast<std::uint32_t>(cells.size()));
      cells.emplace_back();
    }
  }

  void write_filling() {
    filling.write(cells, places);
    const std::size_t made = filling.size();
    for (std::size_t k = 0; k < made; ++k) update_star(places[k]);
    if (made == places.size()) return;
    const auto rest = places.begin() + static_cast<std::ptrdiff_t>(made);
    std::sort(rest, places.end(), std::greater<>());
    std::for_each(rest, places.end(), [this](std::uint32_t c) { drop(c); });
  }

  /// Points that are to be placed, by walks from a cell near them.
  template <class Region>
  void place_hidden(std::uint32_t near, const Region& region) {
    engine.begin_at(near);
    while (hidden.first_loose() != HiddenLists::none) {
      const std::uint32_t v = hidden.first_loose();
      star[v] = engine.locate(v, region);
      hidden.place_first_loose(star[v]);
      engine.begin_at(star[v]);
    }
  }
};

template <class Signs>
ChangingCells3<Signs>::ChangingCells3() : ChangingCells3(CellArray(), 0) {}

template <class Signs>
ChangingCells3<Signs>::ChangingCells3(CellArray cells, std::size_t id_count)
    : state_(std::make_unique<State>(std::move(cells), std::vector<std::uint32_t>(id_count), HiddenLists())) {}

template <class Signs>
ChangingCells3<Signs>::ChangingCells3(const Signs& signs, const std::array<std::uint32_t, 4>& simplex,
                                      std::size_t id_count)
    : ChangingCells3(CellArray(), id_count) {
  state_->signs = signs;
  state_->engine.start(simplex);
  state_->reserve_lists(id_count, state_->cells.size());
  for (std::uint32_t c = 0; c < state_->cells.size(); ++c) state_->update_star(c);
}

template <class Signs>
ChangingCells3<Signs>::~ChangingCells3() = default;
template <class Signs>
ChangingCells3<Signs>::ChangingCells3(ChangingCells3&& other) noexcept = default;
template <class Signs>
ChangingCells3<Signs>& ChangingCells3<Signs>::operator=(ChangingCells3&& other) noexcept = default;

template <class Signs>
ChangingCells3<Signs>::ChangingCells3(const ChangingCells3& other)
    : state_(std::make_unique<State>(other.state_->cells, other.state_->star, other.state_->hidden)) {}

template <class Signs>
ChangingCells3<Signs>& ChangingCells3<Signs>::operator=(const ChangingCells3& other) {
  if (this != &other) *this = ChangingCells3(other);
  return *this;
}

template <class Signs>
const CellArray& ChangingCells3<Signs>::cells() const {
  return state_->cells;
}

template <class Signs>
std::uint32_t ChangingCells3<Signs>::cell_of(std::uint32_t v) const {
  return v == vertex_at_infinity ? state_->ghost : state_->star[v];
}

template <class Signs>
bool ChangingCells3<Signs>::is_hidden(std::uint32_t v) const {
  return state_->hidden.has(v);
}

template <class Signs>
std::size_t ChangingCells3<Signs>::hidden_count() const {
  return state_->hidden.count();
}

template <class Signs>
std::uint32_t ChangingCells3<Signs>::locate(const Signs& signs, std::uint32_t v, std::uint32_t near,
                                            const Context& context) {
  state_->signs = signs;
  state_->engine.begin_at(near);
  return state_->engine.locate(v, PollingRegion(context));
}

template <class Signs>
void ChangingCells3<Signs>::insert(const Signs& signs, std::uint32_t v, std::uint32_t found, const Context& context) {
  State& state = *state_;
  state.signs = signs;
  state.make_room(v);
  if constexpr (Signs::may_hide) {
    if (state.engine.hides(found, v)) {
      state.star[v] = found;
      return state.hidden.put(v, found);
    }
  }
  state.find_conflicts(v, found, context);
  state.engine.fill(v, [&state](std::uint32_t w) { state.hidden.put_loose(w); });
  if (state.hidden.count() > 0) {
    for (const std::uint32_t c : state.engine.conflicts()) state.hidden.loosen(c);
  }
  for (const std::uint32_t c : state.engine.new_cells()) state.update_star(c);
  CellPool& pool = state.engine.pool();
  pool.sort();
  while (pool.size() > 0) state.drop(pool.take());
  if constexpr (Signs::may_hide) state.place_hidden(state.star[v], WholeRegion());
}

template <class Signs>
bool ChangingCells3<Signs>::remove(const Signs& signs, std::uint32_t v, const Context& context) {
  State& state = *state_;
  state.signs = signs;
  if (!state.filling.find(state.cells, state.hidden, v, state.star[v], context)) return false;
  state.find_places();
  if (state.hidden.count() > 0) {
    for (const std::uint32_t w : state.filling.shown()) state.hidden.take(w);
    for (const std::uint32_t c : state.filling.star()) state.hidden.loosen(c);
  }
  const std::uint32_t beside = state.filling.neighbour();
  state.write_filling();
  if constexpr (Signs::may_hide) state.place_hidden(state.star[beside], WholeRegion());
  return true;
}

template <class Signs>
void ChangingCells3<Signs>::hide(const Signs& signs, std::span<const std::uint32_t> points, const Context& context) {
  State& state = *state_;
  state.signs = signs;
  const PollingRegion region(context);
  state.engine.begin_at(0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 256 == 0) context.poll();
    state.make_room(points[i]);
    const std::uint32_t found = state.engine.locate(points[i], region);
    state.star[points[i]] = found;
    state.hidden.put(points[i], found);
    state.engine.begin_at(found);
  }
}

template <class Signs>
void ChangingCells3<Signs>::remove_hidden(std::uint32_t v) {
  state_->hidden.take(v);
}

template <class Signs>
void ChangingCells3<Signs>::turn_over() {
  quoin::turn_over(state_->cells);
}

template class ChangingCells3<DelaunaySigns>;
template class ChangingCells3<RegularSigns>;

}  // namespace quoin
