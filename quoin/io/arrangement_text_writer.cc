// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <ostream>

#include "quoin/base/error.h"
#include "quoin/io/arrangement_text.h"
#include "quoin/io/text_order.h"

namespace quoin {

namespace {

using io::FamilyText;

template <CurveFamily F>
class Writer {
 public:
  Writer(std::ostream& out, const Arrangement<F>& arrangement)
      : out_(out), arrangement_(arrangement), order_(io::text_order(arrangement)) {
    number_supports();
    vertex_numbers_.assign(arrangement.vertex_count(), 0);
    for (std::size_t i = 0; i < order_.vertices.size(); ++i) {
      vertex_numbers_[order_.vertices[i].index()] = static_cast<std::uint32_t>(i);
    }
  }

  void write(std::span<const std::string> names, const CellMembers* members) {
    if (!names.empty() && names.size() != arrangement_.curve_count()) {
      throw InputError("an arrangement of " + std::to_string(arrangement_.curve_count()) + " curves has " +
                       std::to_string(names.size()) + " names");
    }
    out_ << "quoin-arrangement 1 " << FamilyText<F>::name << "\ncurves " << arrangement_.curve_count() << "\nnames "
         << (names.empty() ? "no" : "yes") << "\n";
    for (const std::string& name : names) out_ << "name " << io::encoded_name(name) << "\n";
    write_supports();
    write_vertices();
    write_edges();
    out_ << "faces " << order_.faces.size() << "\n";
    if (members == nullptr) {
      out_ << "members none\n";
    } else {
      write_members(*members);
    }
    out_ << "end\n";
  }

 private:
  /// Those in use, in their order.
  void number_supports() {
    const F& family = arrangement_.family();
    numbers_.assign(family.support_count(), io::no_support);
    const auto use = [&](std::uint32_t support) {
      if (support != io::no_support) numbers_[support] = 0;
    };
    for (const dcel::EdgeId e : order_.edges) use(FamilyText<F>::support(arrangement_.branch(e)));
    for (const dcel::VertexId v : order_.vertices) {
      for (const std::uint32_t support : FamilyText<F>::supports_of(arrangement_.point(v))) use(support);
    }
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (numbers_[i] == io::no_support) continue;
      numbers_[i] = static_cast<std::uint32_t>(supports_.size());
      supports_.push_back(static_cast<std::uint32_t>(i));
    }
  }

  void write_supports() {
    out_ << "supports " << supports_.size() << "\n";
    for (const std::uint32_t support : supports_) {
      out_ << FamilyText<F>::support_words(arrangement_.family(), support) << "\n";
    }
  }

  void write_vertices() {
    out_ << "vertices " << order_.vertices.size() << "\n";
    for (const dcel::VertexId v : order_.vertices) {
      out_ << FamilyText<F>::point_words(arrangement_.family(), arrangement_.point(v), numbers_) << "\n";
    }
  }

  void write_edges() {
    out_ << "edges " << order_.edges.size() << "\n";
    for (const dcel::EdgeId e : order_.edges) {
      out_ << "edge " << FamilyText<F>::branch_word(arrangement_.family(), arrangement_.branch(e), numbers_) << " "
           << vertex_numbers_[arrangement_.left(e).index()] << " " << vertex_numbers_[arrangement_.right(e).index()];
      for (const CurveUse use : arrangement_.curves(e)) {
        out_ << (use.is_reversed() ? " -" : " +") << use.curve().index();
      }
      out_ << "\n";
    }
  }

  void write_members(const CellMembers& members) {
    const CellMembers usual = io::closed_members(arrangement_, members.faces);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < order_.faces.size(); ++i) {
      if (members.faces[order_.faces[i].index()]) lines.push_back("face " + std::to_string(i) + " in");
    }
    const auto add_exceptions = [&](const char* kind, const auto& order, const std::vector<bool>& is,
                                    const std::vector<bool>& expected) {
      for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_member = is[order[i].index()];
        if (is_member != expected[order[i].index()]) {
          lines.push_back(kind + std::to_string(i) + (is_member ? " in" : " out"));
        }
      }
    };
    add_exceptions("edge ", order_.edges, members.edges, usual.edges);
    std::vector<bool> vertices = members.vertices;  // ends at infinity are no members
    for (const dcel::VertexId v : order_.vertices) {
      if (!arrangement_.cells().is_real(v)) vertices[v.index()] = false;
    }
    add_exceptions("vertex ", order_.vertices, vertices, usual.vertices);
    out_ << "members " << lines.size() << "\n";
    for (const std::string& line : lines) out_ << line << "\n";
  }

  std::ostream& out_;
  const Arrangement<F>& arrangement_;
  io::TextOrder<F> order_;
  io::SupportNumbers numbers_;           // by support
  std::vector<std::uint32_t> supports_;  // by number
  std::vector<std::uint32_t> vertex_numbers_;
};

}  // namespace

template <CurveFamily F>
void write_arrangement_text(std::ostream& out, const Arrangement<F>& arrangement, std::span<const std::string> names) {
  Writer<F>(out, arrangement).write(names, nullptr);
}

template <CurveFamily F>
void write_arrangement_text(std::ostream& out, const PolygonSet<F>& set, std::span<const std::string> names) {
  const CellMembers members{set.vertex_members(), set.edge_members(), set.face_members()};
  Writer<F>(out, set.arrangement()).write(names, &members);
}

template <class ArrangementOrSet>
void write_arrangement_text(const std::filesystem::path& path, const ArrangementOrSet& what,
                            std::span<const std::string> names) {
  std::ofstream out(path, std::ios::binary);
  if (!out) throw FileError(path.string() + ": cannot be written");
  write_arrangement_text(out, what, names);
  out.close();
  if (!out) throw FileError(path.string() + ": writing failed");
}

template void write_arrangement_text(std::ostream&, const LinearArrangement&, std::span<const std::string>);
template void write_arrangement_text(std::ostream&, const CircularArrangement&, std::span<const std::string>);
template void write_arrangement_text(std::ostream&, const GeodesicArrangement&, std::span<const std::string>);
template void write_arrangement_text(std::ostream&, const LinearPolygonSet&, std::span<const std::string>);
template void write_arrangement_text(std::ostream&, const CircularPolygonSet&, std::span<const std::string>);
template void write_arrangement_text(std::ostream&, const GeodesicPolygonSet&, std::span<const std::string>);
using Path = std::filesystem::path;
template void write_arrangement_text(const Path&, const LinearArrangement&, std::span<const std::string>);
template void write_arrangement_text(const Path&, const CircularArrangement&, std::span<const std::string>);
template void write_arrangement_text(const Path&, const GeodesicArrangement&, std::span<const std::string>);
template void write_arrangement_text(const Path&, const LinearPolygonSet&, std::span<const std::string>);
template void write_arrangement_text(const Path&, const CircularPolygonSet&, std::span<const std::string>);
template void write_arrangement_text(const Path&, const GeodesicPolygonSet&, std::span<const std::string>);

}  // namespace quoin
