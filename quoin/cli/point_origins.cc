// SPDX-License-Identifier: Apache-2.0
#include "quoin/cli/point_origins.h"

#include <algorithm>
#include <array>
#include <utility>

#include "quoin/number/rational.h"

namespace quoin::cli {

namespace {

/// The exact mean, rounded to the nearest double.
template <class Number>
double mean(std::span<const std::uint32_t> at, const Number& number) {
  Rational sum;
  for (const std::uint32_t i : at) sum += Rational(number(i));
  return at.empty() ? 0 : (sum / Rational(static_cast<double>(at.size()))).to_double();
}

Vector3 mean(const std::vector<Vector3>& values, std::span<const std::uint32_t> at) {
  return {mean(at, [&](std::uint32_t i) { return values[i].x; }),
          mean(at, [&](std::uint32_t i) { return values[i].y; }),
          mean(at, [&](std::uint32_t i) { return values[i].z; })};
}

double mean(const std::vector<double>& values, std::span<const std::uint32_t> at) {
  return mean(at, [&](std::uint32_t i) { return values[i]; });
}

Color mean(const std::vector<Color>& values, std::span<const std::uint32_t> at) {
  Color mean{};
  if (at.empty()) return mean;
  for (const auto channel : {&Color::r, &Color::g, &Color::b, &Color::a}) {
    std::size_t sum = 0;
    for (const std::uint32_t i : at) sum += values[i].*channel;
    mean.*channel = static_cast<std::uint8_t>((2 * sum + at.size()) / (2 * at.size()));
  }
  return mean;
}

template <class Value>
std::vector<Value> means(const std::vector<Value>& values, const PointOrigins& origins) {
  std::vector<Value> result;
  if (values.empty()) return result;
  result.reserve(origins.size());
  for (std::size_t i = 0; i < origins.size(); ++i) {
    const std::uint32_t given = origins.given()[i];
    result.push_back(given == PointOrigins::none ? mean(values, origins.of(i)) : values[given]);
  }
  return result;
}

template <class Value>
std::vector<Value> chosen(const std::vector<Value>& values, std::span<const std::uint32_t> inputs) {
  std::vector<Value> result;
  if (values.empty()) return result;
  result.reserve(inputs.size());
  for (const std::uint32_t i : inputs) result.push_back(values[i]);
  return result;
}

void add_numbers(ExactColumns& columns, const char* name, const auto& values, const auto& number_of) {
  ExactNumbers& column = columns.numbers.emplace_back(name, ExactNumbers()).second;
  for (const auto& value : values) column.add(number_of(value));
}

}  // namespace

PointOrigins origins_of(const FlowMesh& mesh, const Delaunay3& triangulation) {
  // Points with those at the first corners of triangles around them, each once.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> around;
  around.reserve(2 * mesh.triangles.size());
  for (const std::array<std::uint32_t, 3>& t : mesh.triangles) {
    for (const unsigned k : {1U, 2U}) around.emplace_back(t[k], triangulation.inputs(mesh.vertex_of[t[0]])[0]);
  }
  std::ranges::sort(around);
  around.erase(std::unique(around.begin(), around.end()), around.end());
  PointOrigins origins;
  std::vector<std::uint32_t> inputs;
  auto at = around.begin();
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    if (mesh.vertex_of[i] != FlowMesh::constructed) {
      origins.add_given(triangulation.inputs(mesh.vertex_of[i])[0]);
      continue;
    }
    for (inputs.clear(); at != around.end() && at->first == i; ++at) inputs.push_back(at->second);
    origins.add_made(inputs);
  }
  return origins;
}

VertexData data_of(const PointFile& file, const PointOrigins& origins) {
  return {means(file.normals, origins), means(file.colors, origins), means(file.intensities, origins),
          means(file.weights, origins)};
}

VertexData data_of(const PointFile& file, std::span<const std::uint32_t> inputs) {
  return {chosen(file.normals, inputs), chosen(file.colors, inputs), chosen(file.intensities, inputs),
          chosen(file.weights, inputs)};
}

void add_data(VtkGrid& grid, VertexData data) {
  grid.normals = std::move(data.normals);
  grid.colors = std::move(data.colors);
  if (!data.intensities.empty()) grid.point_doubles.emplace_back("intensity", std::move(data.intensities));
  if (!data.weights.empty()) grid.point_doubles.emplace_back("weight", std::move(data.weights));
}

void add_data(ExactColumns& columns, const VertexData& data) {
  static constexpr std::array<std::pair<const char*, std::uint8_t Color::*>, 4> channels{
      {{"red", &Color::r}, {"green", &Color::g}, {"blue", &Color::b}, {"alpha", &Color::a}}};
  for (const auto& [name, channel] : channels) {
    if (data.colors.empty()) break;
    std::vector<std::uint32_t>& column = columns.integers.emplace_back(name, std::vector<std::uint32_t>()).second;
    for (const Color& color : data.colors) column.push_back(color.*channel);
  }
  const auto itself = [](double value) { return value; };
  if (!data.weights.empty()) add_numbers(columns, "weight", data.weights, itself);
  if (!data.intensities.empty()) add_numbers(columns, "intensity", data.intensities, itself);
  if (data.normals.empty()) return;
  add_numbers(columns, "nx", data.normals, [](const Vector3& v) { return v.x; });
  add_numbers(columns, "ny", data.normals, [](const Vector3& v) { return v.y; });
  add_numbers(columns, "nz", data.normals, [](const Vector3& v) { return v.z; });
}

}  // namespace quoin::cli
