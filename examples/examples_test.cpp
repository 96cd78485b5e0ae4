// SPDX-License-Identifier: MIT

// The examples say what is known of their inputs.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

std::string output_of(const std::string& command, int status = 0) {
  std::FILE* pipe = popen((std::string(EXAMPLES) + "/" + command + " 2>/dev/null").c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  EXPECT_EQ(WEXITSTATUS(pclose(pipe)), status) << command;
  return text;
}
std::string input(const std::string& file) { return std::string(INPUTS) + "/" + file; }

struct segment {
  std::string kind;
  std::array<double, 4> ends;
};
std::vector<segment> segments_of(const std::string& svg) {
  std::vector<segment> result;
  std::istringstream in(svg);
  for (std::string line; std::getline(in, line);) {
    segment s;
    std::array<char, 32> kind{};
    auto& e = s.ends;
    if (std::sscanf(line.c_str(), "<line class=\"%31[a-z]\" x1=\"%lf\" y1=\"%lf\" x2=\"%lf\" y2=\"%lf\"", kind.data(), &e[0], &e[1], &e[2], &e[3]) !=
        5)
      continue;
    s.kind = kind.data();
    result.push_back(s);
  }
  return result;
}

TEST(Examples, CentreLinesOfACrossingMeetInTheMiddle) {
  EXPECT_EQ(output_of("road_centre_lines " + input("plus.xy")),
            "MULTILINESTRING M ((0 -9 2, 0 0 2), (0 0 2, 0 9 2), (0 0 2, -9 0 2), (0 0 2, 9 0 2))\n");
}

TEST(Examples, HipRoofsAreClosed) {
  // Walls, floor, and the roof: two of the eight edges are on one line and get one face, unless one of them does not move.
  for (const auto& [more, expected] : {std::pair("", 8 + 1 + 7), {" 40", 8 + 1 + 7}, {" 40 1", 8 + 1 + 7}, {" 60 3", 8 + 1 + 8}}) {
    std::istringstream in(output_of("hip_roof " + input("outline.xy") + more));
    std::map<std::pair<int, int>, int> edges;
    int faces = 0;
    for (std::string line; std::getline(in, line);) {
      if (line.rfind("f ", 0) != 0) continue;
      ++faces;
      std::istringstream corners(line.substr(2));
      std::vector<int> face;
      for (int c = 0; corners >> c;) face.push_back(c);
      for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
    }
    EXPECT_EQ(faces, expected) << more;
    for (const auto& [edge, times] : edges) {
      EXPECT_EQ(times, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
  }
}

TEST(Examples, ASquareIsCutByItsDiagonalsAndMiddleLines) {
  std::map<std::string, int> count;
  for (const segment& s : segments_of(output_of("fold_and_cut " + input("square.xy")))) ++count[s.kind];
  EXPECT_EQ(count, (std::map<std::string, int>{{"arc", 8}, {"cut", 4}, {"perpendicular", 8}}));
}

// Kawasaki's theorem: around a point of a flat folding every other angle adds up to half a turn.
TEST(Examples, CreasesOfASwanFoldFlat) {
  const auto all = segments_of(output_of("fold_and_cut " + input("swan.xy")));
  const auto near = [](double x, double y, double u, double v) { return std::hypot(x - u, y - v) < 1e-7; };
  int nodes = 0;
  for (const segment& of : all) {
    if (of.kind != "arc") continue;
    for (const int end : {0, 2}) {
      const double x = of.ends[end];
      const double y = of.ends[end + 1];
      bool inner = true;
      std::vector<double> angles;
      for (const segment& s : all)
        for (const int at : {0, 2}) {
          if (!near(s.ends[at], s.ends[at + 1], x, y)) continue;
          inner = inner && s.kind != "cut";
          angles.push_back(std::atan2(s.ends[3 - at] - y, s.ends[2 - at] - x));
        }
      std::sort(angles.begin(), angles.end());
      angles.erase(std::unique(angles.begin(), angles.end(), [](double a, double b) { return std::abs(a - b) < 1e-6; }), angles.end());
      if (angles.size() > 1 && angles.front() + 2 * std::numbers::pi - angles.back() < 1e-6) angles.pop_back();
      if (!inner || angles.size() < 3) continue;  // a corner, or an end at the border
      ++nodes;
      double sum = 0;
      for (std::size_t i = 0; i + 1 < angles.size(); i += 2) sum += angles[i + 1] - angles[i];
      EXPECT_EQ(angles.size() % 2, 0U) << "at " << x << ", " << y;
      EXPECT_NEAR(sum, std::numbers::pi, 1e-6) << "at " << x << ", " << y;
    }
  }
  EXPECT_GT(nodes, 20);
}

TEST(Examples, RefuseWhatIsNoPolygon) {
  for (const char* name : {"road_centre_lines", "hip_roof", "fold_and_cut"}) {
    output_of(name, 2);
    output_of(std::string(name) + " " + input("CMakeLists.txt"), 3);
  }
}

}  // namespace
