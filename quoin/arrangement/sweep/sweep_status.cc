// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sweep/sweep_status.h"

namespace quoin {

std::uint32_t SweepStatus::new_node() {
  if (!free_nodes_.empty()) {
    const std::uint32_t node = free_nodes_.back();
    free_nodes_.pop_back();
    nodes_[node] = Node{};
    return node;
  }
  nodes_.emplace_back();
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

std::uint32_t SweepStatus::new_chunk(std::size_t place) {
  std::uint32_t chunk;
  if (free_chunks_.empty()) {
    chunk = static_cast<std::uint32_t>(chunks_.size());
    chunks_.emplace_back();
  } else {
    chunk = free_chunks_.back();
    free_chunks_.pop_back();
  }
  chunks_[chunk].count = 0;
  order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(place), chunk);
  for (std::size_t i = place; i < order_.size(); ++i) chunks_[order_[i]].place = static_cast<std::uint32_t>(i);
  return chunk;
}

void SweepStatus::split(std::uint32_t chunk) {
  const std::uint32_t upper = new_chunk(chunks_[chunk].place + 1);
  Chunk& from = chunks_[chunk];
  Chunk& to = chunks_[upper];
  const std::uint32_t kept = from.count / 2;
  to.count = from.count - kept;
  for (std::uint32_t i = 0; i < to.count; ++i) {
    to.nodes[i] = from.nodes[kept + i];
    nodes_[to.nodes[i]].chunk = upper;
  }
  from.count = kept;
}

void SweepStatus::put(std::uint32_t chunk, std::uint32_t index, std::uint32_t node) {
  Chunk& c = chunks_[chunk];
  std::copy_backward(c.nodes.begin() + index, c.nodes.begin() + c.count, c.nodes.begin() + c.count + 1);
  c.nodes[index] = node;
  ++c.count;
  nodes_[node].chunk = chunk;
}

std::uint32_t SweepStatus::insert_above(std::uint32_t below) {
  const std::uint32_t node = new_node();
  const std::uint32_t above = below == none ? lowest_ : nodes_[below].above;
  nodes_[node].below = below;
  nodes_[node].above = above;
  (below == none ? lowest_ : nodes_[below].above) = node;
  (above == none ? highest_ : nodes_[above].below) = node;
  if (below == none && above == none) {
    put(new_chunk(0), 0, node);
    return node;
  }
  const std::uint32_t neighbour = below == none ? above : below;
  if (chunks_[nodes_[neighbour].chunk].count == chunk_size) split(nodes_[neighbour].chunk);
  const std::uint32_t chunk = nodes_[neighbour].chunk;
  const Chunk& c = chunks_[chunk];
  const auto at =
      static_cast<std::uint32_t>(std::find(c.nodes.begin(), c.nodes.begin() + c.count, neighbour) - c.nodes.begin());
  put(chunk, below == none ? at : at + 1, node);
  return node;
}

void SweepStatus::erase(std::uint32_t node) {
  const Node& n = nodes_[node];
  (n.below == none ? lowest_ : nodes_[n.below].above) = n.above;
  (n.above == none ? highest_ : nodes_[n.above].below) = n.below;
  Chunk& c = chunks_[n.chunk];
  const auto end = c.nodes.begin() + c.count;
  const auto at = std::find(c.nodes.begin(), end, node);
  std::copy(at + 1, end, at);
  if (--c.count == 0) {
    order_.erase(order_.begin() + c.place);
    for (std::size_t i = c.place; i < order_.size(); ++i) chunks_[order_[i]].place = static_cast<std::uint32_t>(i);
    free_chunks_.push_back(n.chunk);
  }
  nodes_[node].head = none;  // whoever remembers the node sees that it is gone
  free_nodes_.push_back(node);
}

}  // namespace quoin
