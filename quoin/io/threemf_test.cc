// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/io/mesh_objects.h"
#include "quoin/io/test_archives.h"
#include "quoin/solid/measure.h"
#include "quoin/solid/solid.h"

namespace quoin {
namespace {

using io::test::corner_mesh;
using io::test::model;
using io::test::package;

const Context context;

MeshFile read(const std::string& bytes) {
  return read_mesh(bytes, "x.3mf", {}, context);
}

std::string object(int id, const std::string& content, const std::string& attributes = "") {
  return "<object id=\"" + std::to_string(id) + "\"" + attributes + ">" + content + "</object>\n";
}

std::string component(int id, const std::string& transform = "") {
  return "<component objectid=\"" + std::to_string(id) + "\"" +
         (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}

std::string item(int id, const std::string& transform = "") {
  return "<item objectid=\"" + std::to_string(id) + "\"" +
         (transform.empty() ? "" : " transform=\"" + transform + "\"") + "/>";
}

std::string components(const std::string& list) {
  return "<components>" + list + "</components>";
}

// The message that a file is refused with.
std::string refusal(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(read)";
}

void expect_refused(const std::string& bytes, const std::string& what) {
  const std::string message = refusal(bytes);
  EXPECT_NE(message.find(what), std::string::npos) << message << "\n  lacks\n" << what;
  EXPECT_TRUE(message.starts_with("x.3mf: ")) << message;
}

bool warns(const MeshFile& file, const std::string& what) {
  return std::ranges::any_of(file.report.warnings, [&](const std::string& w) { return w.find(what) != w.npos; });
}

Rational volume_of(const Mesh& mesh) {
  const LeafResult made = make_leaf(mesh, {}, context);
  EXPECT_TRUE(made.leaf);
  EXPECT_EQ(made.diagnosis.inverted_components.count, 0U);
  return made.leaf ? volume(Solid::from_leaf(made.leaf, context).boundary(), context) : Rational(0);
}

TEST(Threemf, OneObjectWithoutNameIsAMesh) {
  const MeshFile file = read(package(model(object(7, corner_mesh()), item(7))));
  EXPECT_EQ(file.report.format, MeshFormat::threemf);
  EXPECT_EQ(file.report.vertices_in_file, 4U);
  EXPECT_EQ(file.mesh.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(file.mesh.corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  EXPECT_EQ(file.mesh.name, "x");
  EXPECT_TRUE(file.groups.empty());
  EXPECT_TRUE(file.report.warnings.empty()) << file.report.warnings[0];
}

TEST(Threemf, CoordinatesAreTheNearestDoubles) {
  const std::string vertices =
      "<mesh><vertices><vertex x=\"0.1\" y=\" +1e-400 \" z=\"-.5E1\"></vertex></vertices><triangles/></mesh>";
  const MeshFile file = read(package(model(object(1, vertices), item(1, "1 0 0 0 1 0 0 0 1 0 0 0"))));
  EXPECT_EQ(file.mesh.vertices, (std::vector<Point3>{{0.1, 0, -5}}));
  EXPECT_EQ(file.report.warnings, std::vector<std::string>{"no faces; vertices in the file: 1"});
}

TEST(Threemf, ItemsAreObjectsAndMeshesAreGroups) {
  const std::string resources = object(1, corner_mesh(), " name=\"a &amp; b\"") + object(2, corner_mesh("2")) +
                                object(3,
                                       components(component(1) + component(2, "1 0 0 0 1 0 0 0 1 9 0 0") +
                                                  component(1, "1 0 0 0 1 0 0 0 1 0 9 0")),
                                       " name=\"both\"");
  const MeshFile file =
      read(package(model(resources, item(1) + item(3, "1 0 0 0 1 0 0 0 1 0 0 50") +
                                        item(1, "1 0 0 0 1 0 0 0 1 0 0 -9") + item(2, "1 0 0 0 1 0 0 0 1 99 0 0"))));
  std::vector<std::string> names;
  for (const MeshGroup& g : file.groups) names.push_back(g.object + "/" + g.group + "/" + std::to_string(g.first_face));
  EXPECT_EQ(names, (std::vector<std::string>{"a & b/a & b/0", "both/a & b/4", "both/object 2/8", "both/a & b 2/12",
                                             "a & b 2/a & b/16", "object 2/object 2/20"}));
  const std::vector<MeshObject> objects = objects_of(file, context);
  ASSERT_EQ(objects.size(), 4U);
  EXPECT_EQ(objects[1].groups.size(), 3U);
  EXPECT_EQ(volume_of(objects[1].whole), Rational(Integer(10), Integer(6)));
  EXPECT_EQ(objects[1].groups[1].vertices[0], (Point3{9, 0, 50}));
  EXPECT_TRUE(file.report.warnings.empty()) << file.report.warnings[0];
}

// p' = p M for rows: a turn about z by 90 degrees, then a shift; and first the component's map, then the item's.
TEST(Threemf, TransformsStandBehindRowVectors) {
  const std::string turn = "0 1 0 -1 0 0 0 0 1 10 20 30";
  const MeshFile once = read(package(model(object(1, corner_mesh()), item(1, turn))));
  EXPECT_EQ(once.mesh.vertices, (std::vector<Point3>{{10, 20, 30}, {10, 21, 30}, {9, 20, 30}, {10, 20, 31}}));
  const std::string stretched =
      object(1, corner_mesh()) + object(2, components(component(1, "3 0 0 0 1 0 0 0 1 0 0 0")));
  const MeshFile twice = read(package(model(stretched, item(2, turn))));
  EXPECT_EQ(twice.mesh.vertices, (std::vector<Point3>{{10, 20, 30}, {10, 23, 30}, {9, 20, 30}, {10, 20, 31}}));
  EXPECT_EQ(volume_of(twice.mesh), Rational(Integer(1), Integer(2)));
}

TEST(Threemf, MirrorsKeepSolidsOutward) {
  const std::string mirror = "1 0 0 0 -1 0 0 0 1 0 0 0";
  const std::string resources = object(1, corner_mesh()) + object(2, components(component(1, mirror)));
  const Rational sixth(Integer(1), Integer(6));
  EXPECT_EQ(volume_of(read(package(model(resources, item(1, mirror)))).mesh), sixth);
  EXPECT_EQ(volume_of(read(package(model(resources, item(2)))).mesh), sixth);
  const MeshFile both = read(package(model(resources, item(2, mirror))));
  EXPECT_EQ(both.mesh.corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
}

TEST(Threemf, WhatTransformsRoundIsSaid) {
  const MeshFile file = read(package(model(object(1, corner_mesh("0.3")), item(1, "0.1 0 0 0 1 0 0 0 1 0 0 1"))));
  EXPECT_EQ(file.mesh.vertices[1], (Point3{(Rational(0.3) * Rational(0.1)).to_double(), 0, 1}));
  ASSERT_EQ(file.report.warnings.size(), 1U);  // 0.3 times 0.1, and 0.3 + 1
  EXPECT_TRUE(
      file.report.warnings[0].starts_with("coordinates that transforms made are rounded to doubles: 2, by at most 5.6"))
      << file.report.warnings[0];
  const std::string far = "1e300 0 0 0 1 0 0 0 1 0 0 0";
  expect_refused(package(model(object(1, corner_mesh("1e300")), "\n" + item(1, far))),
                 "3D/3dmodel.model:6: the transforms");
}

TEST(Threemf, UnitsTypesAndUnusedObjectsAreSaid) {
  const std::string resources = "<basematerials id=\"9\"/>" + object(1, corner_mesh(), " pid=\"9\" type=\"model\"") +
                                object(2, corner_mesh(), " type=\"support\"") +
                                object(3, corner_mesh("3"), " type=\"surface\"") + object(4, corner_mesh()) +
                                object(5, components(component(2)), " type=\"other\"");
  const MeshFile file =
      read(package(model(resources, item(1) + item(2) + item(3) + item(5), " unit=\"inch\" xmlns:b=\"urn:beams\"")));
  EXPECT_EQ(file.mesh.face_count(), 8U);
  EXPECT_TRUE(warns(file, "the unit of coordinates is inch"));
  EXPECT_TRUE(warns(file, "objects of type 'support' are left out: 1 (object 2)"));
  EXPECT_TRUE(warns(file, "objects of type 'other' are left out: 1 (object 5)"));
  EXPECT_TRUE(warns(file, "objects that the build does not name are left out: 1 (object 4)"));
  EXPECT_TRUE(warns(file, "materials and colours are not kept"));
  EXPECT_EQ(file.report.warnings.size(), 5U);
  EXPECT_TRUE(warns(read(package(model(object(1, corner_mesh()), ""))), "the build names no object"));
}

TEST(Threemf, ExtensionsAreSaidOrRefused) {
  const std::string beams = " xmlns:b=\"urn:beams\"";
  std::string mesh = corner_mesh();
  mesh.insert(mesh.find("</mesh>"), "<b:beamlattice><b:beams><b:beam v1=\"0\" v2=\"1\"/></b:beams></b:beamlattice>");
  EXPECT_TRUE(warns(read(package(model(object(1, mesh), item(1), beams))),
                    "elements 'b:beamlattice' are not read: 1 (object 1)"));
  expect_refused(package(model(object(1, mesh), item(1), beams + " requiredextensions=\"b\"")),
                 "3D/3dmodel.model:2: the model requires the extension 'b' (urn:beams), which is not read");
  expect_refused(package(model(object(1, mesh), item(1), " requiredextensions=\"q\"")),
                 "extension 'q' is not declared");
  const std::string known =
      " xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
      "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" requiredextensions=\" m p\"";
  EXPECT_EQ(read(package(model(object(1, corner_mesh()), item(1), known))).mesh.face_count(), 4U);
}

TEST(Threemf, ObjectsOfOtherParts) {
  const std::string production = " xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";
  const std::string named =
      "<component objectid=\"1\" p:path=\"/3D/Other.model\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/>";
  const auto files = [&](const std::string& other, const std::string& use) {
    return io::test::archive({{"_rels/.rels", io::test::relationships},
                              {"3D/3dmodel.model", model(object(4, components(use)), item(4), production)},
                              {"3D/Other.model", other}});
  };
  const MeshFile file = read(files(model(object(1, corner_mesh()), ""), named));
  EXPECT_EQ(file.mesh.vertices[0], (Point3{5, 0, 0}));
  EXPECT_TRUE(file.report.warnings.empty()) << file.report.warnings[0];
  expect_refused(files(model(object(2, corner_mesh()), ""), named),
                 "3D/3dmodel.model:3: the object 1 is not defined in the part '3D/Other.model'");
  expect_refused(files(model(object(1, "<mesh>"), ""), named), "3D/Other.model:3: ");
  expect_refused(files(model(object(1, corner_mesh()), "", " unit=\"inch\""), named), "in another unit");
  expect_refused(
      files(model(object(1, components("<component objectid=\"4\" p:path=\"/3D/3dmodel.model\"/>")), "", production),
            named),
      "3D/Other.model:3: only the model");
  expect_refused(files("", "<component objectid=\"1\" p:path=\"/3D/None.model\"/>"),
                 "the part '3D/None.model' is not there");
  expect_refused(files("", "<component objectid=\"1\" q:path=\"/3D/None.model\"/>"),
                 "'q:path' belongs to no extension");
  expect_refused(files("", "<component objectid=\"4\" p:path=\"/3d/3DModel.model\"/>"),
                 "the object 4 is not defined before");
}

TEST(Threemf, PrefixesOfTheCore) {
  std::string text = model(object(1, corner_mesh()), item(1));
  for (const char* name :
       {"model", "resources", "object", "mesh", "vertices", "vertex", "triangles", "triangle", "build", "item"}) {
    for (const std::string begin : {"<", "</"}) {
      for (const std::string end : {" ", ">"}) {
        const std::string from = begin + name + end;
        for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + from.size() + 2))
          text.replace(at, from.size(), begin + "c:" + name + end);
      }
    }
  }
  text.replace(text.find(" xmlns="), 7, " xmlns:c=");
  EXPECT_EQ(read(package(text)).mesh.face_count(), 4U);
}

TEST(Threemf, WhatIsNotWellMadeIsRefusedWithItsLine) {
  const std::string mesh = corner_mesh();
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = mesh;
    text.replace(text.find(from), from.size(), to);
    return package(model("\n" + object(1, text), item(1)));
  };
  const std::string line = "3D/3dmodel.model:4: ";
  expect_refused(changed("v3=\"1\"", "v3=\"4\""), line + "vertex 4 is not there");
  expect_refused(changed("v3=\"1\"", "v3=\"-1\""), line + "'-1' for 'v3' is no index");
  expect_refused(changed("v3=\"1\"", "v3=\"4294967296\""), line + "'4294967296' for 'v3' is no index");
  expect_refused(changed("v3=\"1\"", "v3=\"\""), line + "'' for 'v3' is no index");
  expect_refused(changed("v3=\"1\"", ""), line + "the element 'triangle' has no attribute 'v3'");
  expect_refused(changed("x=\"1\"", "x=\"nan\""), line + "'nan' for 'x' is not a finite number");
  expect_refused(changed("x=\"1\"", "x=\"inf\""), line + "'inf'");
  expect_refused(changed("x=\"1\"", "x=\"1e309\""), line + "'1e309'");
  expect_refused(changed("x=\"1\"", "x=\"1,5\""), line + "'1,5'");
  expect_refused(changed("x=\"1\"", ""), line + "the element 'vertex' has no attribute 'x'");
  expect_refused(changed("</vertices>", ""), "closes no element");
  expect_refused(changed("</mesh>", "</mesh><mesh/>"), line + "an object has more than one mesh");
  expect_refused(changed("</vertices>", "</vertices><vertices/>"), line + "a mesh has two lists of vertices");
  expect_refused(changed("<vertices>", "<triangles/><vertices>"), line + "triangles stand before the vertices");
  expect_refused(package(model(object(1, "<mesh/>"), item(1))), "without vertices");
  expect_refused(package(model(object(1, ""), item(1))), "neither a mesh nor components");
  expect_refused(package(model(object(1, "<components/>"), item(1))), "is empty");
  expect_refused(package(model(object(0, mesh), item(0))), "should be from 1");
  expect_refused(package(model(object(1, mesh) + object(1, mesh), item(1))),
                 "3D/3dmodel.model:4: the object 1 is there twice");
  expect_refused(package(model(object(1, mesh, " type=\"thing\""), item(1))), "'thing' is no type");
  expect_refused(package(model(object(1, mesh), item(1), " unit=\"mile\"")), "'mile' is no unit");
  expect_refused(package(model(object(1, mesh), item(2))), "3D/3dmodel.model:5: the object 2 is not defined");
  expect_refused(package(model(object(1, mesh), item(1, "1 0 0 0 1 0 0 0 1 0 0"))), "a transform of 11 numbers");
  expect_refused(package(model(object(1, mesh), item(1, "1 0 0 0 1 0 0 0 1 0 0 x"))), "'x' for 'transform'");
  expect_refused(package(model(object(1, mesh), item(1, "1 0 0 0 1 0 1 1 0 0 0 0"))),
                 "3D/3dmodel.model:5: the transform flattens space");
  expect_refused(package("<model/>"), "is not of the namespace");
  expect_refused(package("<html/>"), "the element 'model' should stand here");
  expect_refused(package(""), "there is no element");
  expect_refused(package(model(object(1, mesh), item(1)) + "<model/>"), "nothing should stand behind");
  expect_refused(package(std::string("<\0m\0", 4)), "UTF-16");
}

TEST(Threemf, ComponentsNameWhatStandsBefore) {
  const std::string mesh = object(1, corner_mesh());
  expect_refused(package(model(mesh + object(2, components("\n" + component(2))), item(2))),
                 "3D/3dmodel.model:5: the object 2 is not defined before this line");
  expect_refused(package(model(object(2, components(component(3))) + object(3, components(component(2))), item(2))),
                 "the object 3 is not defined before");
  std::string deep = mesh;
  for (int k = 2; k < 100; ++k) deep += object(k, components(component(k - 1, "1 0 0 0 1 0 0 0 1 1 0 0")));
  EXPECT_EQ(read(package(model(deep, item(99)))).mesh.vertices[0], (Point3{98, 0, 0}));
  deep += object(100, components(component(99))) + object(101, components(component(100)));
  expect_refused(package(model(deep, item(101))), "nest deeper than 100");
}

// Twice the object before, forty times over.
TEST(Threemf, SmallFilesOfLargeMeshesAreRefused) {
  for (const std::string& content : {corner_mesh(), std::string("<mesh><vertices/><triangles/></mesh>")}) {
    for (const char* type : {"", " type=\"other\""}) {
      std::string resources = object(1, content, type);
      for (int k = 2; k <= 90; ++k) resources += object(k, components(component(k - 1) + component(k - 1)));
      expect_refused(package(model(resources, item(90))), "a mesh of more than 4 GB");
    }
  }
}

TEST(Threemf, ArchivesThatAreNoPackages) {
  const std::string text = model(object(1, corner_mesh()), item(1));
  const auto files = [&](const io::test::ArchiveFaults& faults) {
    return io::test::archive({{"_rels/.rels", io::test::relationships}, {"3D/3dmodel.model", text}}, faults);
  };
  EXPECT_EQ(read(files({})).mesh.face_count(), 4U);
  expect_refused(io::test::archive({}), "the archive is empty");
  expect_refused(io::test::archive({{"readme.txt", "nothing"}}), "no 3MF file: it has no part '3D/3dmodel.model'");
  expect_refused(io::test::archive({{"_rels/.rels", "<Relationships/>"}, {"3D/3dmodel.model", text}}),
                 "names no 3D model");
  expect_refused(io::test::archive({{"_rels/.rels", io::test::relationships}}), "it has no part '3D/3dmodel.model'");
  expect_refused(
      io::test::archive(
          {{"_rels/.rels", io::test::relationships}, {"3D/3dmodel.model", text}, {"3d/3DMODEL.model", text}}),
      "is there twice");
  const MeshFile bare = read(io::test::archive({{"3d/3dModel.model", text}}));
  EXPECT_EQ(bare.mesh.face_count(), 4U);
  EXPECT_TRUE(warns(bare, "'_rels/.rels'"));
  expect_refused(files({.flags = 1}), "encrypted");
  expect_refused(files({.method = 12}), "packed by method 12");
  expect_refused(files({.method = 8}), "damaged");
  expect_refused(files({.checksum_change = 1}), "damaged");
  expect_refused(files({.declared_more = 3}), "'3D/3dmodel.model': the part");
  expect_refused(files({.declared_more = 0xF0000000U}), "size that its data cannot have");
  expect_refused(files({.declared_parts = 1}), "damaged");
  expect_refused("no archive", "a zip archive should begin here");
}

// A large archive's end, whose locator the ordinary end stands behind: no memory is taken for what it promises.
TEST(Threemf, EndsThatPromiseTooManyParts) {
  const std::string text = package(model(object(1, corner_mesh()), item(1)));
  const std::size_t end = text.size() - 22;
  const auto number = [](std::uint64_t value, int count) {
    std::string bytes;
    for (int k = 0; k < count; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFF);
    return bytes;
  };
  const auto large = [&](std::uint64_t parts) {
    const std::string directory = text.substr(end + 12, 8);  // size and begin, 4 bytes each
    return text.substr(0, end) + "PK\6\6" + number(44, 8) + number(45, 2) + number(45, 2) + number(0, 8) +
           number(parts, 8) + number(parts, 8) + directory.substr(0, 4) + number(0, 4) + directory.substr(4) +
           number(0, 4) + "PK\6\7" + number(0, 4) + number(end, 8) + number(1, 4) + "PK\5\6" + number(0, 4) +
           std::string(12, '\xFF') + number(0, 2);
  };
  EXPECT_EQ(read(large(2)).mesh.face_count(), 4U);
  for (const std::uint64_t parts : {std::uint64_t{1} << 20, std::uint64_t{1} << 40, ~std::uint64_t{0}})
    expect_refused(large(parts), "promises more parts than it has room for");
}

TEST(Threemf, TheRelationshipsNameTheModel) {
  const std::string text = model(object(1, corner_mesh()), item(1));
  const auto named = [&](const std::string& from, const std::string& to) {
    std::string relationships = io::test::relationships;
    relationships.replace(relationships.find(from), from.size(), to);
    return io::test::archive({{"_rels/.rels", relationships}, {"Other/a model.xml", text}});
  };
  EXPECT_EQ(read(named("/3D/3dmodel.model", "/Other/a%20model.xml")).mesh.face_count(), 4U);
  EXPECT_EQ(read(named("/3D/3dmodel.model", "other/A model.xml")).mesh.face_count(), 4U);
  expect_refused(named("/3D/3dmodel.model", "/"), "_rels/.rels:2: the relationship names no part");
  expect_refused(named("Target=\"/3D/3dmodel.model\"", ""), "no attribute 'Target'");
  expect_refused(named(" Id=", " TargetMode=\"External\" Id="), "not in the package");
}

// Whatever is done to a file: an InputError or a mesh.
TEST(Threemf, DamagedFilesAreRefusedOrRead) {
  const std::string whole = package(
      model(object(1, corner_mesh()) + object(2, components(component(1, "2 0 0 0 1 0 0 0 1 0 0 0"))), item(2)));
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_NE(refusal(whole.substr(0, size)), "(read)") << size;
  std::mt19937 random(17);
  for (int round = 0; round < test_rounds(4000); ++round) {
    std::string bytes = whole;
    for (std::size_t k = 1 + random() % 4; k > 0; --k) bytes[random() % bytes.size()] = static_cast<char>(random());
    refusal(bytes);
  }
}

// The same in the text, behind an archive that is whole.
TEST(Threemf, DamagedModelsAreRefusedOrRead) {
  const std::string whole = model(
      object(1, corner_mesh(), " name=\"&#65;&lt;\"") + object(2, components(component(1, "2 0 0 0 1 0 0 0 1 0 0 0"))),
      item(2));
  for (std::size_t size = 0; size + 9 < whole.size(); ++size)
    EXPECT_NE(refusal(package(whole.substr(0, size))), "(read)") << size;
  std::mt19937 random(18);
  const std::string signs = "<>/\"='& 0129.-xe\n:";
  int read_count = 0;
  for (int round = 0; round < test_rounds(4000); ++round) {
    std::string text = whole;
    for (std::size_t k = 1 + random() % 3; k > 0; --k) text[random() % text.size()] = signs[random() % signs.size()];
    if (random() % 4 == 0) text.erase(random() % text.size(), random() % 40);
    read_count += refusal(package(text)) == "(read)" ? 1 : 0;
  }
  EXPECT_GE(read_count, test_cases(100));
}

TEST(Threemf, IsNotWritten) {
  std::ostringstream out;
  EXPECT_THROW(
      write_mesh(out, MeshFormat::threemf, read(package(model(object(1, corner_mesh()), item(1)))).mesh, context),
      InputError);
  EXPECT_TRUE(out.str().empty());
  EXPECT_EQ(format_from_path("A.3MF"), MeshFormat::threemf);
}

TEST(Threemf, ReadingCanBeCancelled) {
  Context cancelled;
  cancelled.cancel();
  EXPECT_THROW(read_mesh(package(model(object(1, corner_mesh()), item(1))), "x.3mf", {}, cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
