// SPDX-License-Identifier: MIT

// Every file of planar_bad_input names in its first line what is wrong with it: `# expect: FAULT SUBSTRING OF THE MESSAGE`, or in GeoJSON
// `{"expect": "FAULT SUBSTRING",`.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "osteon/input/make_polygon.hpp"
#include "osteon/input/read_polygon.hpp"
#include "osteon/kernel/integer.hpp"
#include "osteon/models/polyhedra.hpp"

namespace osteon::plane {
namespace {

const std::filesystem::path folder = std::filesystem::path(OSTEON_MODELS).parent_path() / "planar_bad_input";

const std::map<std::string, input_fault> faults = {
    {"empty", input_fault::empty},
    {"not_obj", input_fault::not_obj},
    {"bad_number", input_fault::bad_number},
    {"absurd_size", input_fault::absurd_size},
    {"bad_index", input_fault::bad_index},
    {"zero_area", input_fault::zero_area},
    {"not_planar", input_fault::not_planar},
    {"self_intersection", input_fault::self_intersection},
    {"not_polygon", input_fault::not_polygon},
    {"short_ring", input_fault::short_ring},
    {"spike", input_fault::spike},
    {"pinched", input_fault::pinched},
    {"misplaced_ring", input_fault::misplaced_ring},
    {"bad_weight", input_fault::bad_weight},
};

polygon<integer> read(const std::string& text, const std::string& name) {
  std::istringstream in(text);
  return make_polygon(read_polygon<integer>(in, name));
}

input_fault fault_of(const std::string& text, const std::string& name) {
  try {
    read(text, name);
  } catch (const input_error& e) {
    EXPECT_EQ(std::string(e.what()).rfind(name + ":", 0), 0U) << e.what();
    EXPECT_NE(std::string(e.what()).find("; hint: "), std::string::npos) << e.what();
    return e.fault;
  }
  ADD_FAILURE() << "accepted";
  return {};
}

TEST(PlanarBadInput, EveryFileIsRefusedWithItsOwnMessage) {
  int files = 0;
  std::set<input_fault> seen;
  std::map<std::string, std::string> messages;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++files;
    const std::string name = entry.path().filename().string();
    SCOPED_TRACE(name);
    std::ifstream in(entry.path(), std::ios::binary);
    std::string first;
    std::getline(in, first);
    const bool json = first.rfind("{\"expect\": \"", 0) == 0;
    const bool comment = first.rfind("# expect: ", 0) == 0;
    ASSERT_TRUE(json || comment);
    std::istringstream line(json ? first.substr(12, first.size() - 14) : first.substr(10));
    std::string fault;
    std::string substring;
    line >> fault >> std::ws;
    std::getline(line, substring);
    ASSERT_TRUE(faults.contains(fault)) << fault;
    ASSERT_FALSE(substring.empty());
    in.clear();
    in.seekg(0);
    try {
      make_polygon(read_polygon<integer>(in, name));
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
  EXPECT_GE(files, 70);
  EXPECT_EQ(seen.size(), faults.size()) << "a fault without a file";
}

TEST(PlanarBadInput, FaultsThatFilesCannotShow) {
  EXPECT_EQ(fault_of("", "a.xy"), input_fault::empty);
  EXPECT_EQ(fault_of("", "nameless"), input_fault::empty);
  EXPECT_EQ(fault_of("", "a.json"), input_fault::not_polygon);
  EXPECT_EQ(fault_of("# " + std::string(longest_line, 'x'), "a.xy"), input_fault::absurd_size);
  EXPECT_EQ(fault_of(std::string(longest_line + 1, '0') + " 0", "a.xy"), input_fault::absurd_size);
  EXPECT_EQ(fault_of("POLYGON ((" + std::string(longest_line + 1, '0') + " 0", "a.wkt"), input_fault::absurd_size);
  EXPECT_EQ(fault_of("{\"" + std::string(longest_line + 1, '0') + "\"", "a.json"), input_fault::absurd_size);
  EXPECT_EQ(fault_of("{\"a\":" + std::string(1'000'000, '['), "a.json"), input_fault::absurd_size);
  EXPECT_EQ(fault_of("{\"type\":\"Polygon\",\"coordinates\":" + std::string(1'000'000, '['), "a.json"), input_fault::absurd_size);
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "{\"geometry\":";
  EXPECT_EQ(fault_of(deep, "a.json"), input_fault::absurd_size);
  EXPECT_EQ(fault_of(std::string("0 0\n1 \0 0\n", 10), "a.xy"), input_fault::not_polygon);
  EXPECT_EQ(fault_of("\x7F"
                     "ELF\x01\x01",
                     "a.xy"),
            input_fault::bad_number);
  EXPECT_EQ(fault_of("\x7F"
                     "ELF\x01\x01",
                     "a"),
            input_fault::not_polygon);
  std::ifstream missing(folder / "no_such_file");
  EXPECT_THROW(read_polygon<integer>(missing, "no_such_file"), input_error);
  EXPECT_THROW(read_xy<integer>(missing, "no_such_file"), input_error);
  std::ifstream directory(folder);
  EXPECT_THROW(read_polygon<integer>(directory, "a.xy"), input_error);
}

TEST(PlanarBadInput, MessagesCarryNothingThatATerminalObeys) {
  for (const std::string name : {"a.xy", "a.wkt", "a.json"}) try {
      read("\x1B[31m\xC3\n", name);
      ADD_FAILURE() << "accepted";
    } catch (const input_error& e) {
      EXPECT_EQ(std::string(e.what()).find('\x1B'), std::string::npos) << e.what();
    }
}

// A coordinate far finer than all others would blow every one of them up to its length.
TEST(PlanarBadInput, MemoryForFineDigitsIsLimited) {
  std::string text = std::string(1000, '7') + "e-1399 0\n";
  for (int i = 0; i < 400'000; ++i) text += "1e390 0\n";
  EXPECT_EQ(fault_of(text, "a.xy"), input_fault::absurd_size);
  auto r = make_rings<integer>({{{0, 0}, {1, 0}, {0, 1}}}, {{1, 2, 3}});
  r.all[0].points[1][0] = {1, -2'000'000'000, -2'000'000'000};
  EXPECT_THROW(make_polygon(r), input_error);
  r.all[0].points[1][0] = {1, 2'000'000'000, 0};
  EXPECT_THROW(make_polygon(r), input_error);
  r.all[0].points[1][0] = {1, 0, 0};
  r.all[0].weights[1].two = -2'000'000'000;
  EXPECT_THROW(make_polygon(r), input_error);
}

// The same limit as that of solids (bad_input_test).
TEST(PlanarBadInput, ScaleIsLimitedToAHundredThousandBits) {
  const auto triangle = [](const exact_number<integer>& height) {
    auto r = make_rings<integer>({{{0, 0}, {1, 0}, {0, 1}}}, {{1, 1, 1}});
    r.all[0].points[2][1] = height;
    return r;
  };
  EXPECT_EQ(make_polygon(triangle({1, -30'000, 0})).ten, -30'000);
  EXPECT_EQ(make_polygon(triangle({1, 0, -100'000})).two, -100'000);
  EXPECT_THROW(make_polygon(triangle({1, -30'031, 0})), input_error);
  EXPECT_THROW(make_polygon(triangle({1, 0, -100'001})), input_error);
  auto r = triangle({1, 0, 0});
  r.all[0].weights[1] = {1, 0, -100'000};
  EXPECT_EQ(make_polygon(r).weight_two, -100'000);
  r.all[0].weights[1] = {1, 0, -100'001};
  EXPECT_THROW(make_polygon(r), input_error);
}

// A text whose format nothing tells gets a message that names all of them.
TEST(PlanarBadInput, UnknownFormatsAreToldWhatIsRead) {
  const auto message = [](const std::string& text, const std::string& name) -> std::string {
    try {
      read(text, name);
    } catch (const input_error& e) {
      return e.what();
    }
    return "read";
  };
  for (const std::string text : {"", "# nothing\n", "POINT (0 0)", "\x01", "OFF\n8 6 12\n", "solid cube"})
    for (const char* format : {"lines of points", "well-known text", "GeoJSON", "OBJ"})
      EXPECT_NE(message(text, "plan.dat").find(format), std::string::npos) << message(text, "plan.dat");
  EXPECT_EQ(message("", "plan.xy").find("GeoJSON"), std::string::npos) << message("", "plan.xy");
}

TEST(PlanarBadInput, RingsFromMemory) {
  EXPECT_THROW(make_polygon(rings<integer>{}), input_error);
  EXPECT_THROW(make_polygon(make_rings<integer>({{}})), input_error);
  EXPECT_THROW(make_rings<integer>({{{0, 0}, {NAN, 0}, {0, 1}}}), input_error);
  EXPECT_THROW(make_rings<integer>({{{0, 0}, {INFINITY, 0}, {0, 1}}}), input_error);
  EXPECT_THROW(make_rings<integer>({{{0, 0}, {1, 0}, {0, 1}}}, {{1, 2, NAN}}), input_error);
  EXPECT_THROW(make_rings<integer>({{{0, 0}, {1, 0}, {0, 1}}}, {{1, 2}}), input_error);
  EXPECT_THROW(make_rings<integer>({{{0, 0}, {1, 0}, {0, 1}}}, {{1, 2, 3}, {1}}), input_error);
  EXPECT_THROW(make_polygon(make_rings<integer>({{{0, 0}, {1, 0}, {0, 1}}}, {{1, 2, -3}})), input_error);
  auto r = make_rings<integer>({{{0, 0}, {1, 0}, {0, 1}}}, {{1, 2, 3}});
  r.all[0].weights.pop_back();
  EXPECT_THROW(make_polygon(r), input_error);
}

// Texts with random damage are read or refused, and nothing else happens.
TEST(PlanarBadInput, DamagedTexts) {
  const std::map<std::string, std::string> texts = {
      {"a.xy", "# x\n0 0 1\n10 0 2.5\n10 1e1\n0 10 0\n0 0\n\n2 2\n2 3\n3 2 # hole\n"},
      {"a.wkt", "SRID=4326; MULTIPOLYGON Z (((0 0 1, 10 0 1, 0 10 1, 0 0 1), (1 1 1, 2 1 1, 1 2 1)), ((20 20 1, 20 30 1, 30 20 1)))"},
      {"a.json",
       R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"a": [1, null, {"b": "\"c"}]}, "geometry": {"coordinates": [[[0, 0], [9, 0], [0, 9]]], "type": "Polygon"}}]})"},
      {"a.obj", "v 0 0 1\nv 9 0 1\nv 0 9 1\nf 1 2 3\n"}};
  int accepted = 0;
  for (const auto& [name, text] : texts) {
    EXPECT_NO_THROW(read(text, name));
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
      SCOPED_TRACE(name + " seed " + std::to_string(seed));
      models::dice d(seed);
      std::string damaged = text;
      for (long k = d.between(1, 3); k > 0 && !damaged.empty(); --k) {
        const auto at = static_cast<std::size_t>(d.between(0, static_cast<long>(damaged.size()) - 1));
        const auto other = static_cast<std::size_t>(d.between(0, static_cast<long>(damaged.size()) - 1));
        switch (d.between(0, 3)) {
          case 0:
            damaged[at] = static_cast<char>(d.between(-128, 127));
            break;
          case 1:
            damaged.erase(at, static_cast<std::size_t>(d.between(1, 5)));
            break;
          case 2:
            damaged.insert(at, damaged.substr(other, static_cast<std::size_t>(d.between(1, 9))));
            break;
          default:
            damaged[at] = damaged[other];
        }
      }
      try {
        read(damaged, d.between(0, 9) == 0 ? "nameless" : name);
        ++accepted;
      } catch (const input_error& e) {
        EXPECT_NE(std::string(e.what()).find("; hint: "), std::string::npos) << e.what();
      }
    }
  }
  EXPECT_GT(accepted, 500);
}

}  // namespace
}  // namespace osteon::plane
