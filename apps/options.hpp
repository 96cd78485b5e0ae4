// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Options that several commands share: names of choices, ranges of numbers, models with repairs.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input.hpp"
#include "osteon/osteon.hpp"

namespace osteon::app {

inline const std::map<std::string, number_kernel> kernels = {
    {"sqrt", number_kernel::sqrt}, {"rational", number_kernel::rational}, {"double", number_kernel::floating}};
inline const std::map<std::string, split_preference> preferences = {{"convex", split_preference::convex},
                                                                    {"reflex", split_preference::reflex},
                                                                    {"min-volume", split_preference::min_volume},
                                                                    {"max-volume", split_preference::max_volume},
                                                                    {"first", split_preference::first}};
inline const std::map<std::string, saddle_rule> saddles = {
    {"convex", saddle_rule::convex}, {"reflex", saddle_rule::reflex}, {"slower", saddle_rule::slower}, {"faster", saddle_rule::faster}};

/// Returns the names of all choices.
template <class Value>
std::vector<std::string> names(const std::map<std::string, Value>& of) {
  std::vector<std::string> result;
  for (const auto& [name, value] : of) result.push_back(name);
  return result;
}

/// Returns the name of a choice.
template <class Value>
std::string name_in(const std::map<std::string, Value>& of, Value value) {
  return std::find_if(of.begin(), of.end(), [value](const auto& x) { return x.second == value; })->first;
}

/// Returns a check that takes numbers for which `holds`, and nothing else; `what` says what they
/// are.
CLI::Validator number_that(std::function<bool(double)> holds, const std::string& what);
/// Returns a check that takes finite numbers of at least `least`, or any.
CLI::Validator finite_number(std::optional<double> least = std::nullopt);

/// Adds the option `--kernel`.
void add_kernel(CLI::App& command, std::string& kernel, const std::string& what);

/// A polyhedron's file with the repairs that the user asked for.
struct model {
  std::string file;
  mesh_repairs repairs;

  /// Adds the file and the repairs to a command's options.
  void add_to(CLI::App& command, const std::string& what = "a closed polyhedron as Wavefront OBJ");
  /// Reads the file for a command that takes polyhedra only. *Throws* input_error.
  polyhedron read(const std::string& command) const;
  /// Reads a text that is open already.
  polyhedron read(input_text text) const;
};

/// Returns the number of a solid's vertex at a point of the file, counted from 1. *Throws*
/// input_error where there is none.
int vertex_at(const polyhedron& p, const std::string& file, int point);

/// Reads a polygon and says on standard error what was left out. *Throws* input_error.
polygon read_polygon_text(input_text text, checking when);
/// Says on standard error what was repaired.
void print_notes(const std::vector<std::string>& notes);

/// Throws invariant_error where the certificate of a result that the program has just computed is
/// refuted.
void demand_certified(const std::optional<skeleton_refutation>& refuted);

}  // namespace osteon::app
