// SPDX-License-Identifier: MIT

// The examples as their users call them, on their own inputs: what they draw and build has the
// properties that it must have.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

struct result {
  int status;
  std::string output;
  std::string messages;
};

result run(const std::string& command) {
  const std::string file = testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name();
  const int status = std::system((std::string(EXAMPLES) + "/" + command + " >" + file + ".out 2>" + file + ".err").c_str());
  const auto text = [](const std::string& name) {
    std::ostringstream all;
    all << std::ifstream(name).rdbuf();
    std::remove(name.c_str());
    return all.str();
  };
  return {status / 256, text(file + ".out"), text(file + ".err")};
}

std::string input(const std::string& name) { return std::string(INPUTS) + "/" + name; }

std::vector<double> numbers(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
  std::istringstream in(text);
  std::vector<double> all;
  for (double x; in >> x;) all.push_back(x);
  return all;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex r(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator i(text.begin(), text.end(), r); i != std::sregex_iterator(); ++i) all.push_back((*i)[1]);
  return all;
}

TEST(examples, errors) {
  for (const std::string name : {"road_centre_lines", "hip_roof", "fold_and_cut"}) {
    EXPECT_EQ(run(name).status, 2) << name;
    const auto r = run(name + " " + input("missing.xy"));
    EXPECT_EQ(r.status, 3) << name;
    EXPECT_NE(r.messages.find("hint: "), std::string::npos) << name;
    EXPECT_EQ(r.output, "") << name;
  }
  EXPECT_EQ(run("hip_roof " + input("outline.xy") + " 90").status, 2);
  EXPECT_EQ(run("hip_roof " + input("outline.xy") + " 45 0").status, 3);
  EXPECT_EQ(run("hip_roof " + input("outline.xy") + " 45 9").status, 3);
}

TEST(examples, full_disk) {
  for (const std::string call : {"road_centre_lines plus.xy", "hip_roof outline.xy", "fold_and_cut square.xy"}) {
    const auto space = call.find(' ');
    const std::string command = std::string(EXAMPLES) + "/" + call.substr(0, space) + " " + input(call.substr(space + 1));
    EXPECT_EQ(std::system((command + " >/dev/full 2>/dev/null").c_str()) / 256, 6) << call;
  }
}

// ---- roads

using point = std::array<double, 2>;

struct road {
  std::vector<point> points;
  std::vector<double> widths;
};

std::vector<road> roads(const std::string& wkt) {
  std::vector<road> all;
  for (const auto& line : matches(wkt, R"(\(([^()]+)\))")) {
    all.emplace_back();
    const auto x = numbers(line);
    for (std::size_t i = 0; i + 2 < x.size(); i += 3) {
      all.back().points.push_back({x[i], x[i + 1]});
      all.back().widths.push_back(x[i + 2]);
    }
  }
  return all;
}

double length(const std::vector<road>& all) {
  double sum = 0;
  for (const auto& r : all)
    for (std::size_t i = 1; i < r.points.size(); ++i) sum += std::hypot(r.points[i][0] - r.points[i - 1][0], r.points[i][1] - r.points[i - 1][1]);
  return sum;
}

TEST(examples, roads_that_cross) {
  const auto r = run("road_centre_lines " + input("plus.xy"));
  ASSERT_EQ(r.status, 0) << r.messages;
  const auto all = roads(r.output);
  EXPECT_EQ(all.size(), 4U);
  EXPECT_EQ(length(all), 36);  // four arms of 10, less half the width at their ends
  for (const auto& road : all)
    for (const double w : road.widths) EXPECT_EQ(w, 2);
}

TEST(examples, road_without_a_spur) {
  const auto r = run("road_centre_lines " + input("bend.xy"));
  ASSERT_EQ(r.status, 0) << r.messages;
  const auto all = roads(r.output);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(length(all), 16, 1e-12);
}

// All is connected, and there are as many independent cycles as blocks.
TEST(examples, roads_around_blocks) {
  const auto r = run("road_centre_lines " + input("streets.xy"));
  ASSERT_EQ(r.status, 0) << r.messages;
  std::map<point, std::vector<point>> at;
  int lines = 0;
  for (const auto& road : roads(r.output))
    for (std::size_t i = 1; i < road.points.size(); ++i, ++lines) {
      at[road.points[i - 1]].push_back(road.points[i]);
      at[road.points[i]].push_back(road.points[i - 1]);
    }
  std::map<point, bool> seen;
  std::vector<point> next = {at.begin()->first};
  while (!next.empty()) {
    const point p = next.back();
    next.pop_back();
    if (std::exchange(seen[p], true)) continue;
    for (const auto& q : at[p]) next.push_back(q);
  }
  EXPECT_EQ(seen.size(), at.size());
  EXPECT_EQ(lines - static_cast<int>(at.size()) + 1, 3);
  const auto ends = std::count_if(at.begin(), at.end(), [](const auto& n) { return n.second.size() == 1; });
  EXPECT_EQ(ends, 3);  // the roads that lead out of town; no spurs
}

// ---- roofs

void expect_closed(const std::string& obj) {
  std::map<std::pair<int, int>, int> passed;
  for (const auto& f : matches(obj, "f ([0-9 ]+)\n")) {
    const auto c = numbers(f);
    for (std::size_t i = 0; i < c.size(); ++i) ++passed[{static_cast<int>(c[i]), static_cast<int>(c[(i + 1) % c.size()])}];
  }
  EXPECT_GT(passed.size(), 0U);
  for (const auto& [edge, count] : passed) {
    EXPECT_EQ(count, 1) << edge.first << ' ' << edge.second;
    EXPECT_EQ(passed.count({edge.second, edge.first}), 1U) << edge.first << ' ' << edge.second;
  }
}

TEST(examples, hip_roof) {
  const auto hip = run("hip_roof " + input("outline.xy"));
  ASSERT_EQ(hip.status, 0) << hip.messages;
  expect_closed(hip.output);
  // Area 161, all of it at 45 degrees.
  const auto x = numbers(matches(hip.messages, "ridge at ([0-9.]+, [0-9.]+) of").at(0));
  EXPECT_NEAR(x[0], 7, 1e-9);
  EXPECT_NEAR(x[1], 161 * std::sqrt(2.0), 1e-6);
  EXPECT_EQ(matches(hip.output, "(f )").size(), 7U + 8U + 1U);  // the sides beside the wing are one face
}

TEST(examples, gable) {
  const auto gable = run("hip_roof " + input("outline.xy") + " 60 2");
  ASSERT_EQ(gable.status, 0) << gable.messages;
  expect_closed(gable.output);
  const auto x = numbers(matches(gable.messages, "ridge at ([0-9.]+, [0-9.]+) of").at(0));
  EXPECT_NEAR(x[0], 3 + 4 * std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(x[1], 161 * 2, 1e-6);
}

// ---- paper

using line = std::vector<point>;

struct paper {
  std::vector<line> sides, arcs, perpendiculars;
  double size;
  std::array<double, 4> box;  // x, y, width, height
};

paper fold(const std::string& name) {
  const auto r = run("fold_and_cut " + input(name));
  EXPECT_EQ(r.status, 0) << r.messages;
  paper result{};
  const auto lines = [&](const std::string& what) {
    std::vector<line> all;
    for (const auto& text : matches(r.output, "class=\"" + what + "\" points=\"([^\"]+)")) {
      all.emplace_back();
      const auto x = numbers(text);
      for (std::size_t i = 0; i + 1 < x.size(); i += 2) all.back().push_back({x[i], x[i + 1]});
    }
    return all;
  };
  result.sides = lines("side");
  result.arcs = lines("arc");
  result.perpendiculars = lines("perpendicular");
  const std::regex box("class=\"paper\" x=\"(.*)\" y=\"(.*)\" width=\"(.*)\" height=\"(.*)\"/");
  std::smatch m;
  EXPECT_TRUE(std::regex_search(r.output, m, box));
  for (std::size_t i = 0; i < 4; ++i) result.box[i] = std::stod(m[i + 1]);
  result.size = std::max(result.box[2], result.box[3]);
  return result;
}

// The directions of creases from a point, ascending.
std::vector<double> directions(const paper& s, const point& p) {
  std::vector<double> all;
  const double near = 1e-9 * s.size;
  for (const auto* lines : {&s.arcs, &s.perpendiculars})
    for (const line& l : *lines)
      for (std::size_t i = 1; i < l.size(); ++i) {
        const point d = {l[i][0] - l[i - 1][0], l[i][1] - l[i - 1][1]};
        const double length = std::hypot(d[0], d[1]);
        const point a = {p[0] - l[i - 1][0], p[1] - l[i - 1][1]};
        const double along = (a[0] * d[0] + a[1] * d[1]) / length;
        if (length < near || std::abs(a[0] * d[1] - a[1] * d[0]) / length > near || along < -near || along > length + near) continue;
        if (along > near) all.push_back(std::atan2(-d[1], -d[0]));
        if (along < length - near) all.push_back(std::atan2(d[1], d[0]));
      }
  std::sort(all.begin(), all.end());
  return all;
}

// Kawasaki: where creases meet, paper lies flat if and only if every other angle adds up to 180
// degrees.
void expect_flat(const paper& s) {
  const double pi = std::acos(-1.0);
  int checked = 0;
  for (const auto* lines : {&s.arcs, &s.perpendiculars})
    for (const line& l : *lines)
      for (const point& p : l) {
        const double room = std::min({p[0] - s.box[0], p[1] - s.box[1], s.box[0] + s.box[2] - p[0], s.box[1] + s.box[3] - p[1]});
        if (room < 1e-9 * s.size) continue;
        const auto d = directions(s, p);
        ASSERT_EQ(d.size() % 2, 0U) << p[0] << ' ' << p[1];
        double sum = 0;
        for (std::size_t i = 0; i + 1 < d.size(); i += 2) {
          EXPECT_GT(d[i + 1] - d[i], 1e-6) << "two creases on each other at " << p[0] << ' ' << p[1];
          sum += d[i + 1] - d[i];
        }
        EXPECT_NEAR(sum, pi, 1e-9) << p[0] << ' ' << p[1];
        ++checked;
      }
  EXPECT_GT(checked, 0);
}

// Where a perpendicular crosses a side it does so at a right angle. Returns how many crossings
// there are.
int expect_right_angles(const paper& s) {
  int crossings = 0;
  for (const line& l : s.perpendiculars)
    for (std::size_t i = 1; i < l.size(); ++i)
      for (const line& side : s.sides) {
        const point d = {l[i][0] - l[i - 1][0], l[i][1] - l[i - 1][1]};
        const point e = {side[1][0] - side[0][0], side[1][1] - side[0][1]};
        const auto beside = [](const point& o, const point& v, const point& q) { return v[0] * (q[1] - o[1]) - v[1] * (q[0] - o[0]); };
        const double a = beside(side[0], e, l[i - 1]);
        const double b = beside(side[0], e, l[i]);
        // A crossing is a point of the line: its end counts.
        if (std::abs(b) > 1e-9 * s.size * s.size || std::abs(a) < std::abs(b)) continue;
        const double part = ((l[i][0] - side[0][0]) * e[0] + (l[i][1] - side[0][1]) * e[1]) / (e[0] * e[0] + e[1] * e[1]);
        if (part < 1e-9 || part > 1 - 1e-9) continue;
        EXPECT_NEAR((d[0] * e[0] + d[1] * e[1]) / (std::hypot(d[0], d[1]) * std::hypot(e[0], e[1])), 0, 1e-9);
        ++crossings;
      }
  return crossings;
}

TEST(examples, fold_square) {
  const paper s = fold("square.xy");
  EXPECT_EQ(s.sides.size(), 4U);
  EXPECT_EQ(s.arcs.size(), 8U);  // both diagonals, in four parts each
  EXPECT_EQ(s.perpendiculars.size(), 4U);
  EXPECT_EQ(directions(s, {2, 2}).size(), 8U);
  EXPECT_EQ(expect_right_angles(s), 4);
  expect_flat(s);
}

TEST(examples, fold_triangle) {
  const paper s = fold("triangle.xy");
  EXPECT_EQ(s.arcs.size(), 6U);
  EXPECT_EQ(s.perpendiculars.size(), 3U);
  EXPECT_EQ(expect_right_angles(s), 3);
  expect_flat(s);
}

TEST(examples, fold_others) {
  for (const std::string name : {"letter.xy", "star.xy", "plus.xy", "outline.xy", "streets.xy"}) {
    SCOPED_TRACE(name);
    const paper s = fold(name);
    const int crossings = expect_right_angles(s);
    EXPECT_EQ(crossings == 0, name == "star.xy");  // there none enters a face
    expect_flat(s);
  }
}

TEST(examples, dense_perpendiculars_are_given_up) {
  const auto r = run("fold_and_cut " + input("five_pointed_star.xy"));
  EXPECT_EQ(r.status, 0) << r.messages;
  EXPECT_NE(r.messages.find("were given up after 100 arcs"), std::string::npos) << r.messages;
}

}  // namespace
