// SPDX-License-Identifier: MIT

/// \file
/// Runs the properties of one program. 100 cases each, with a fixed seed so that the gate does not flicker; 1,000 with OSTEON_NIGHTLY=1 and
/// a new seed every time. What RC_PARAMS says goes first. The seed is printed: RC_PARAMS="seed=..." repeats a run.

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

int main(int argc, char** argv) {
  const char* nightly = std::getenv("OSTEON_NIGHTLY");
  const bool night = nightly != nullptr && std::string(nightly) == "1";
  const char* given = std::getenv("RC_PARAMS");
  std::string parameters = given == nullptr ? "" : given;
  if (parameters.find("seed=") == std::string::npos && parameters.find("reproduce=") == std::string::npos)
    parameters += " seed=" + std::to_string(night ? std::random_device()() : 20250117U);
  if (parameters.find("max_success=") == std::string::npos) parameters += night ? " max_success=1000" : " max_success=100";
  setenv("RC_PARAMS", parameters.c_str(), 1);
  std::cout << "RC_PARAMS=\"" << parameters << "\"\n";
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
