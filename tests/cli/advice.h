// What `shedlight advise` says, read from its JSON.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/program.h"

inline nlohmann::json advise(const Scratch& folder, const std::string& arguments) {
  const Outcome outcome = folder.shedlight("advise " + arguments + " --json");
  INFO(arguments << "\n" << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  return nlohmann::json::parse(outcome.out);
}

inline std::string verdict(const nlohmann::json& advice, const char* section) {
  return advice.at(section).at("verdict").get<std::string>();
}

inline double value(const nlohmann::json& advice, const char* section, const char* finding) {
  return advice.at(section).at(finding).at("value").get<double>();
}

/// The periods that are no harmonics.
inline nlohmann::json periods(const nlohmann::json& advice) {
  nlohmann::json all = nlohmann::json::array();
  for (const nlohmann::json& period : advice.at("spectrum").at("periods").at("value"))
    if (!period.contains("harmonic")) all.push_back(period);
  return all;
}

/// A synthetic surface, in g.gsf.
inline void make(const Scratch& folder, const std::string& what) {
  folder.prepare("synth " + what + " -o g.gsf");
}
inline const std::string patch = " --size 65um --pixels 650,65";
inline const std::string wide_sinusoid = "sinusoid --period 20um --height 1um" + patch;
