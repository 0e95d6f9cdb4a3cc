// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_cells3.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/triangulation/flat_cells.h"
#include "quoin/triangulation/incremental3.h"
#include "quoin/triangulation/star_filling3.h"

namespace quoin {

struct ChangingCells3::State {
  using Engine = IncrementalTriangulation<DelaunaySigns>;

  DelaunaySigns signs{{}, PointExtent(), no_vertex};
  CellArray cells;
  std::vector<std::uint32_t> star;  ///< a cell of each vertex
  std::uint32_t ghost = 0;
  Engine engine{signs, cells};
  StarFilling3 filling{signs};
  std::vector<std::uint32_t> places;

  State(CellArray from, std::vector<std::uint32_t> star_of) : cells(std::move(from)), star(std::move(star_of)) {
    for (std::uint32_t c = 0; c < cells.size(); ++c) update_star(c);
  }

  void update_star(std::uint32_t c) {
    for (const std::uint32_t v : cells[c].vertices) (v == vertex_at_infinity ? ghost : star[v]) = c;
  }

  void make_room(std::uint32_t v) {
    if (v < star.size()) return;
    const std::size_t size = std::size_t{v} + 1;
    if (size > star.capacity()) star.reserve(std::max(size, 2 * star.capacity()));
    star.resize(size);
  }

  /// The last cell takes the place.
  void drop(std::uint32_t c) {
    const auto last = static_cast<std::uint32_t>(cells.size() - 1);
    if (c != last) {
      cells[c] = cells[last];
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t mate = cells[c].neighbours[i];
        cells[mate >> 2].neighbours[mate & 3] = c * 4 + i;
      }
      update_star(c);
    }
    cells.pop_back();
  }

  /// For what fills the star: the places of the star, and more at the end of the array. All memory that it takes.
  void find_places() {
    places.assign(filling.star().begin(), filling.star().end());
    if (filling.size() <= places.size()) return;
    const std::size_t size = cells.size() + filling.size() - places.size();
    if (size > Engine::most_cells) throw InputError("the triangulation has more than 2^30 cells");
    places.reserve(filling.size());
    if (size > cells.capacity()) cells.reserve(std::max(size, 2 * cells.capacity()));
    while (cells.size() < size) {
      places.push_back(static_cast<std::uint32_t>(cells.size()));
      cells.emplace_back();
    }
  }
};

ChangingCells3::ChangingCells3() : ChangingCells3(CellArray(), 0) {}

ChangingCells3::ChangingCells3(CellArray cells, std::size_t id_count)
    : state_(std::make_unique<State>(std::move(cells), std::vector<std::uint32_t>(id_count))) {}

ChangingCells3::ChangingCells3(const DelaunaySigns& signs, const std::array<std::uint32_t, 4>& simplex,
                               std::size_t id_count)
    : ChangingCells3(CellArray(), id_count) {
  state_->signs = signs;
  state_->engine.start(simplex);
  for (std::uint32_t c = 0; c < state_->cells.size(); ++c) state_->update_star(c);
}

ChangingCells3::~ChangingCells3() = default;
ChangingCells3::ChangingCells3(ChangingCells3&& other) noexcept = default;
ChangingCells3& ChangingCells3::operator=(ChangingCells3&& other) noexcept = default;

ChangingCells3::ChangingCells3(const ChangingCells3& other)
    : state_(std::make_unique<State>(other.state_->cells, other.state_->star)) {}

ChangingCells3& ChangingCells3::operator=(const ChangingCells3& other) {
  if (this != &other) *this = ChangingCells3(other);
  return *this;
}

const CellArray& ChangingCells3::cells() const {
  return state_->cells;
}

std::uint32_t ChangingCells3::cell_of(std::uint32_t v) const {
  return v == vertex_at_infinity ? state_->ghost : state_->star[v];
}

std::uint32_t ChangingCells3::locate(const DelaunaySigns& signs, std::uint32_t v, std::uint32_t near,
                                     const Context& context) {
  state_->signs = signs;
  state_->engine.begin_at(near);
  return state_->engine.locate(v, PollingRegion(context));
}

void ChangingCells3::insert(const DelaunaySigns& signs, std::uint32_t v, std::uint32_t found, const Context& context) {
  State& state = *state_;
  state.signs = signs;
  state.make_room(v);
  state.engine.insert_at(found, v, PollingRegion(context), [](std::uint32_t) {});
  for (const std::uint32_t c : state.engine.new_cells()) state.update_star(c);
  CellPool& pool = state.engine.pool();
  pool.sort();
  while (pool.size() > 0) state.drop(pool.take());
}

bool ChangingCells3::remove(const DelaunaySigns& signs, std::uint32_t v, const Context& context) {
  State& state = *state_;
  state.signs = signs;
  if (!state.filling.find(state.cells, v, state.star[v], context)) return false;
  state.find_places();
  state.filling.write(state.cells, state.places);
  const std::size_t made = state.filling.size();
  for (std::size_t k = 0; k < made; ++k) state.update_star(state.places[k]);
  if (made < state.places.size()) {
    const auto rest = state.places.begin() + static_cast<std::ptrdiff_t>(made);
    std::sort(rest, state.places.end(), std::greater<>());
    std::for_each(rest, state.places.end(), [&state](std::uint32_t c) { state.drop(c); });
  }
  return true;
}

void ChangingCells3::turn_over() {
  quoin::turn_over(state_->cells);
}

}  // namespace quoin
