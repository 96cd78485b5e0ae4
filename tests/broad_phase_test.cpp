// SPDX-License-Identifier: MIT

// The broad phase finds what comparing all pairs finds.

#include "osteon/core/box_tree.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace osteon::plane {
namespace {

using dice = std::mt19937_64;

double between(dice& roll, double low, double high) { return std::uniform_real_distribution<double>(low, high)(roll); }

box box_at(double x, double y, double width, double height) { return {{x, y}, {x + width, y + height}}; }

struct shape {
  const char* name;
  std::function<box(dice&)> draw;
};

std::vector<shape> shapes() {
  return {
      {"even", [](dice& roll) { return box_at(between(roll, 0, 1), between(roll, 0, 1), between(roll, 0, 0.02), between(roll, 0, 0.02)); }},
      {"points", [](dice& roll) { return box_at(between(roll, 0, 1), between(roll, 0, 1), 0, 0); }},
      {"tall", [](dice& roll) { return box_at(between(roll, 0, 1), between(roll, 0, 0.1), 0.001, between(roll, 0.5, 0.9)); }},
      {"clustered", [](dice& roll) { return box_at(0.3 + between(roll, 0, 1e-6), 0.7 + between(roll, 0, 1e-6), 1e-8, 1e-8); }},
      {"equal", [](dice&) { return box_at(0.25, 0.5, 0.25, 0.125); }},
      {"great and small",
       [](dice& roll) {
         const double size = roll() % 10 == 0 ? 0.8 : 0.001;
         return box_at(between(roll, 0, 1), between(roll, 0, 1), size, size);
       }},
      {"beside the frame", [](dice& roll) { return box_at(between(roll, -5, 5), between(roll, -5, 5), 0.1, 0.1); }},
      {"on one line", [](dice& roll) { return box_at(between(roll, 0, 1), 0.5, 0.001, 0); }},
  };
}

TEST(BoxTree, FindsWhatOverlaps) {
  for (const auto& [name, draw] : shapes())
    for (const std::size_t size : {0, 1, 36, 37, 500, 3000})
      for (const std::size_t late : {std::size_t{0}, size / 2, size}) {
        SCOPED_TRACE(std::string(name) + ", " + std::to_string(size) + " boxes, " + std::to_string(late) + " of them late");
        dice roll(size + late);
        box_tree tree;
        for (int run = 0; run < 2; ++run) {  // the second in what the first has left
          tree.clear(box_at(0, 0, 1, 1));
          std::vector<box> all;
          for (std::size_t i = 0; i < size; ++i) {
            all.push_back(draw(roll));
            if (i == size - late) tree.build();
            i < size - late ? tree.add(static_cast<int>(i), all.back()) : tree.insert(static_cast<int>(i), all.back());
          }
          if (late == 0) tree.build();
          for (int question = 0; question < 40; ++question) {
            const box b = draw(roll);
            for (const bool deep : {false, true}) tree.prefetch(b, deep);
            std::set<int> found;
            tree.search(b, [&found](int id) { found.insert(id); });
            for (std::size_t i = 0; i < size; ++i)
              ASSERT_TRUE(!all[i].meets(b) || found.count(static_cast<int>(i)) == 1) << "box " << i << " is not found";
            for (const int i : found) {  // rounding outwards adds a little only, but at the border of the frame
              box more = all[static_cast<std::size_t>(i)];
              more.grow(1e-9);
              ASSERT_TRUE(more.meets(b) || std::string(name) == "beside the frame") << "box " << i << " is found, but far away";
            }
          }
        }
      }
}

}  // namespace
}  // namespace osteon::plane
