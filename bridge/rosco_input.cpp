// SPDX-License-Identifier: Apache-2.0
#include "bridge/rosco_input.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "core/plain_number.hpp"
#include "core/suggest.hpp"

namespace lac {
namespace {

/// Numbers of a DISCON.IN as ROSCO finds them: in the last line whose second word is the key.
class RoscoInput {
 public:
  RoscoInput(const InputFile& bridge, const std::filesystem::path& file)
      : bridge_(bridge), file_(file.string()) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) lines_.push_back(line);
    if (lines_.empty()) fail(file_ + ": cannot be read, or is empty");
  }

  double number(const std::string& key) const { return find(key).value; }

  void require(bool fits, const std::string& key, const std::string& expected) const {
    const Entry found = find(key);
    if (!fits) fail(found.where + "found " + shortest(found.value) + ", expected " + expected);
  }
  void require(const std::string& key, double value, const std::string& why) const {
    require(number(key) == value, key, shortest(value) + why);
  }

 private:
  struct Entry {
    double value = 0.0;
    std::string where;
  };

  /// Cuts the first word off a line; ROSCO's separators.
  static std::string take_word(std::string_view& line) {
    constexpr const char* kSeparators = " ,!;'\"\t\r";
    line.remove_prefix(std::min(line.find_first_not_of(kSeparators), line.size()));
    std::string word(line.substr(0, line.find_first_of(kSeparators)));
    line.remove_prefix(word.size());
    return word;
  }

  Entry find(const std::string& key) const {
    for (std::size_t i = lines_.size(); i-- > 0;) {
      std::string_view rest = lines_[i];
      std::string value = take_word(rest);
      if (!equal_ignoring_case(take_word(rest), key)) continue;
      Entry found{0.0, file_ + ":" + std::to_string(i + 1) + ": " + key + ": "};
      std::ranges::replace_if(
          value, [](char c) { return c == 'd' || c == 'D'; }, 'e');
      const std::optional<double> number = plain_number(value);
      if (!number) fail(found.where + "found '" + value + "', expected a number");
      found.value = *number;
      return found;
    }
    fail(file_ + ": " + key + ": missing");
  }

  [[noreturn]] void fail(const std::string& problem) const { bridge_.fail("RoscoInput", problem); }

  const InputFile& bridge_;
  std::string file_;
  std::vector<std::string> lines_;
};

void check_tower_damper(const RoscoInput& rosco, const BridgeParams& p) {
  const std::string why = " with FeedforwardRoute tower_damper";
  const double authority_rad = p.increment.authority_rad;
  rosco.require("TD_Mode", 1.0, why);
  rosco.require("FA_HPFCornerFreq", 0.0, why);
  rosco.require("FA_KI", p.tower_damper_gain, ", TowerDamperGain");
  rosco.require(rosco.number("FA_IntSat") >= authority_rad, "FA_IntSat",
                "no less than Authority, " + shortest(authority_rad) + " rad");
  rosco.require(rosco.number("Fl_Mode") != 1.0, "Fl_Mode",
                "0 or 2" + why + ": 1 takes the same record for the motion of the tower");
}

void check_hub_wind(const RoscoInput& rosco) {
  const std::string why = " with DeratingRoute hub_wind";
  rosco.require("WE_Mode", 0.0, why);
  rosco.require("PS_Mode", 0.0, why + ": peak shaving would look up the same wind speed");
  rosco.require("PRC_Mode", 2.0, why);
  rosco.require("PRC_Comm", 1.0, why);
  rosco.require("OL_Mode", 1.0, why);
  rosco.require("OL_BP_Mode", 1.0, why);
  rosco.require(rosco.number("Ind_R_Torque") > 0.0, "Ind_R_Torque", "a column of OL_Filename");
  rosco.require(rosco.number("VS_ControlMode") != 2.0, "VS_ControlMode",
                "1, 3 or 4" + why + ": 2 tracks the tip speed ratio of the same wind speed");
}

}  // namespace

void check_rosco_input(const InputFile& in, const std::filesystem::path& discon_in,
                       const BridgeParams& params) {
  const RoscoInput rosco(in, discon_in);
  if (params.feedforward == FeedforwardRoute::TowerDamper) check_tower_damper(rosco, params);
  if (params.derating == DeratingRoute::HubWind) check_hub_wind(rosco);
}

}  // namespace lac
