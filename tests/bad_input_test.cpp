// SPDX-License-Identifier: MIT

// Every file of bad_input names in its first line what is wrong with it: `# expect: FAULT SUBSTRING OF THE MESSAGE`.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "osteon/input/open.hpp"
#include "osteon/input/read_obj.hpp"
#include "osteon/input/solid.hpp"
#include "osteon/kernel/integer.hpp"

namespace osteon {
namespace {

const std::filesystem::path folder = std::filesystem::path(OSTEON_MODELS).parent_path() / "bad_input";

const std::map<std::string, input_fault> faults = {
    {"unreadable", input_fault::unreadable},
    {"empty", input_fault::empty},
    {"not_obj", input_fault::not_obj},
    {"bad_number", input_fault::bad_number},
    {"absurd_size", input_fault::absurd_size},
    {"bad_index", input_fault::bad_index},
    {"short_facet", input_fault::short_facet},
    {"repeated_corner", input_fault::repeated_corner},
    {"repeated_point", input_fault::repeated_point},
    {"unused_point", input_fault::unused_point},
    {"not_closed", input_fault::not_closed},
    {"crowded_edge", input_fault::non_manifold_edge},
    {"inconsistent", input_fault::inconsistent},
    {"inside_out", input_fault::inverted},
    {"zero_area", input_fault::zero_area},
    {"not_planar", input_fault::not_planar},
    {"folded", input_fault::folded},
    {"two_fans", input_fault::non_manifold_vertex},
    {"self_intersection", input_fault::self_intersection},
};

input_mesh<integer> read(const std::string& text) {
  std::istringstream in(text);
  return read_obj<integer>(in, "text.obj");
}

input_fault fault_of(const std::string& text) {
  try {
    make_solid(read(text));
  } catch (const input_error& e) {
    EXPECT_NE(std::string(e.what()).find("text.obj"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("; hint: "), std::string::npos) << e.what();
    return e.fault;
  }
  ADD_FAILURE() << "accepted";
  return {};
}

TEST(BadInput, EveryFileIsRefusedWithItsOwnMessage) {
  int files = 0;
  std::set<input_fault> seen;
  std::map<std::string, std::string> messages;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++files;
    const std::string name = entry.path().filename().string();
    SCOPED_TRACE(name);
    std::ifstream in(entry.path(), std::ios::binary);
    std::string hash;
    std::string expect;
    std::string fault;
    std::string substring;
    in >> hash >> expect >> fault >> std::ws;
    std::getline(in, substring);
    ASSERT_EQ(hash + expect, "#expect:");
    ASSERT_TRUE(faults.contains(fault)) << fault;
    ASSERT_FALSE(substring.empty());
    in.seekg(0);
    try {
      make_solid(read_obj<integer>(in, name));
      ADD_FAILURE() << "accepted";
    } catch (const input_error& e) {
      const std::string what = e.what();
      EXPECT_EQ(static_cast<int>(e.fault), static_cast<int>(faults.at(fault))) << what;
      EXPECT_NE(what.find(substring), std::string::npos) << what;
      EXPECT_EQ(what.rfind(name + ":", 0), 0U) << what;
      EXPECT_NE(what.find("; hint: "), std::string::npos) << what;
      const auto [other, fresh] = messages.emplace(what, name);
      EXPECT_TRUE(fresh) << "same message as " << other->second;
      seen.insert(e.fault);
    }
  }
  EXPECT_GE(files, 45);
  EXPECT_EQ(seen.size(), faults.size() - 1) << "a fault without a file";  // files cannot show unreadable
}

TEST(BadInput, FaultsThatFilesCannotShow) {
  EXPECT_EQ(fault_of(""), input_fault::empty);
  EXPECT_EQ(fault_of("# " + std::string(longest_line, 'x')), input_fault::absurd_size);
  EXPECT_EQ(fault_of("v 0 0 " + std::string(longest_line, '0')), input_fault::absurd_size);
  std::string joined = "f 1";
  while (joined.size() < 2 * longest_line) joined += " 1 \\\n 2";
  EXPECT_EQ(fault_of(joined), input_fault::absurd_size);
  std::ifstream missing(folder / "no_such_file");
  EXPECT_THROW(read_obj<integer>(missing, "no_such_file"), input_error);
  std::ifstream directory(folder);
  EXPECT_THROW(read_obj<integer>(directory, "a folder"), input_error);
}

TEST(BadInput, FilesThatCannotBeOpened) {
  const auto message = [](const std::filesystem::path& file) -> std::string {
    try {
      open_file(file.string());
    } catch (const input_error& e) {
      EXPECT_EQ(e.fault, input_fault::unreadable);
      return e.what();
    }
    return "opened";
  };
  EXPECT_EQ(message(folder / "no_such_file"), (folder / "no_such_file").string() + ": cannot be opened: there is no such file; hint: check the name");
  EXPECT_EQ(message(folder), folder.string() + ": cannot be opened: it is a folder; hint: name a file in it");
  EXPECT_NE(message("").find("cannot be opened"), std::string::npos);
  EXPECT_NE(message("-").find("no such file"), std::string::npos) << "only a program knows that this is standard input";
  EXPECT_EQ(message(folder / "off.obj"), "opened");
}

TEST(BadInput, AnEmptyFileIsNotOneWithoutStatements) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      read(text);
    } catch (const input_error& e) {
      return e.what();
    }
    return "read";
  };
  EXPECT_NE(message("").find("the file is empty"), std::string::npos);
  EXPECT_NE(message("# a comment").find("neither points nor facets"), std::string::npos);
}

TEST(BadInput, MessagesCarryNothingThatATerminalObeys) {
  try {
    read("v 0 0 \x1B[31m\xC3\n");
    ADD_FAILURE() << "accepted";
  } catch (const input_error& e) {
    EXPECT_NE(std::string(e.what()).find("'?[31m?'"), std::string::npos) << e.what();
  }
}

TEST(BadInput, ErrorsNameTheFirstOfJoinedLines) {
  try {
    read("v 0 0 0\n\nv 0 \\\n 0 \\\n zero\n");
    ADD_FAILURE() << "accepted";
  } catch (const input_error& e) {
    EXPECT_EQ(e.element, 3U);
    EXPECT_NE(std::string(e.what()).find("text.obj:3: 'zero'"), std::string::npos) << e.what();
  }
}

// A coordinate far finer than all others would blow every one of them up to its length.
TEST(BadInput, MemoryForFineDigitsIsLimited) {
  std::string text = "v " + std::string(1000, '7') + "e-1399 0 0\n";
  for (int i = 0; i < 250'000; ++i) text += "v 1e390 0 0\n";
  EXPECT_EQ(fault_of(text + "f 1 2 3\n"), input_fault::absurd_size);
  input_mesh<integer> m = read("v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
  m.points[1][0] = {1, -2'000'000'000, -2'000'000'000};
  EXPECT_THROW(make_solid(m), input_error);
  m.points[1][0] = {1, 0, 0};
  m.points[0][0].ten = 2'000'000'000;
  EXPECT_THROW(make_solid(m), input_error);
}

// The same limit as that of polygons (planar_bad_input_test).
TEST(BadInput, ScaleIsLimitedToAHundredThousandBits) {
  const auto tetrahedron = [](const exact_number<integer>& height) {
    auto m = make_input_mesh<integer>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    m.points[3][2] = height;
    return m;
  };
  EXPECT_EQ(make_solid(tetrahedron({1, -30'000, 0})).ten, -30'000);
  EXPECT_EQ(make_solid(tetrahedron({1, 0, -100'000})).two, -100'000);
  EXPECT_THROW(make_solid(tetrahedron({1, -30'031, 0})), input_error);
  EXPECT_THROW(make_solid(tetrahedron({1, 0, -100'001})), input_error);
}

TEST(BadInput, LargestIndexDoesNotOverflow) {
  auto m = make_input_mesh<integer>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2'147'483'647}});
  EXPECT_THROW(make_solid(m), input_error);
  m.facets[0][2] = -2'147'483'647 - 1;
  EXPECT_THROW(make_solid(m), input_error);
}

// A tetrahedron, spelled in many ways.
TEST(OddInput, IsReadRight) {
  const std::string plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const std::map<std::string, std::string> spellings = {
      {"plain", plain},
      {"CRLF", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1\r\nf 1 3 2\r\nf 1 2 4\r\nf 2 3 4\r\nf 1 4 3\r\n"},
      {"CR", "# old\rv 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 1\rf 1 3 2\rf 1 2 4\rf 2 3 4\rf 1 4 3"},
      {"byte order mark", "\xEF\xBB\xBF" + plain},
      {"continuation", "v 0 \\\n0 0\nv 1 0\\\r\n 0\nv 0 1 0\nv 0 0 1\nf \\\n\\\n1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\\\n"},
      {"tabs and spaces", "\tv\t0  0\t0 \n  v 1 0 0\t\n\nv 0 1 0   \nv 0 0 1\n \t\nf\t1 3\t2 \nf 1 2 4\nf 2 3 4\nf 1 4 3  "},
      {"comments", "# a path C:\\models\\\nv 0 0 0#here\nv 1 0 0 # there \\\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4 #\nf 2 3 4\nf 1 4 3 ## end"},
      {"negative indices", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n"},
      {"facets first", "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"},
      {"textures and normals", "mtllib a.mtl\no x\nvt 0 0\nvn 0 0 1\n" + plain.substr(0, 32) +
                                   "g y\nusemtl z\ns off\nf 1/1 3/1 2/1\nf 1/1/1 2/1/1 4/1/1\nf 2//1 3//1 4//1\nf 1/-1/-1 4// 3/\n"},
      {"colours", "v 0 0 0 1 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1 0.5 0 1\nv 0 0 1 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"},
      {"numbers", "v 0.0 -0 0e5\nv 10E-1 .0 0.\nv +0 +1.000 -.0\nv 0 0 0.01e+2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3"},
  };
  const auto expected = make_solid(read(plain));
  for (const auto& [name, text] : spellings) {
    SCOPED_TRACE(name);
    const auto s = make_solid(read(text));
    EXPECT_EQ(s.points, expected.points);
    std::set<moving_plane<integer>> planes(s.planes.begin(), s.planes.end());
    EXPECT_EQ(planes, std::set<moving_plane<integer>>(expected.planes.begin(), expected.planes.end()));
    EXPECT_EQ(s.ten, 0);
  }
}

TEST(OddInput, LinesAreCountedWithAnyEnds) {
  const auto m = read("v 0 0 0\r\n\r\nv 1 0 0\rv 0 1 0\n\nf 1 \\\r\n2 \\\n3\nf 3 2 1");
  EXPECT_EQ(m.point_lines, (std::vector<std::size_t>{1, 3, 4}));
  EXPECT_EQ(m.facet_lines, (std::vector<std::size_t>{6, 9}));
}

}  // namespace
}  // namespace osteon
