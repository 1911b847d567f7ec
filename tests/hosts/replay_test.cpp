// SPDX-License-Identifier: Apache-2.0
// Calls recorded from OpenFAST v5.0.0 (tests/data/README.md), made again to our master: that it
// can be flown there is proved without OpenFAST.
#include <gmock/gmock.h>

#include <map>
#include <set>
#include <sstream>

#include "core/discon_library.hpp"
#include "hosts/trace_replay.hpp"
#include "support/temp_folder.hpp"

namespace lac::test {
namespace {

const std::string kData = LAC_SOURCE_DIR "/tests/data/openfast/";
constexpr int kFirstLidarRecord = 2005, kGates = 5;
constexpr int kLidarValues = 4 * kGates;  // speeds, x, y, z

class OpenFastReplay : public testing::Test {
 protected:
  TraceReplay replay(const std::string& chain, const std::string& root) const {
    return {master_.entry(), chain, folder_.file(root + ".SrvD")};
  }

  /// Plays a trace and compares every record of every call with the recorded answer: to the last
  /// bit if the compiler is the one of the recording, else the demands within rounding.
  void expect_as_recorded(TraceReplay& player, const std::string& trace) const {
    const bool same_compiler = TraceReader(kData + trace).compiler() == __VERSION__;
    int n = 0;
    for (const TraceCall& call : TraceReplay::read(kData + trace)) {
      const std::vector<float>& answer = player.play(call);
      ASSERT_EQ(player.fail(), call.fail) << trace << ", call " << n << ": " << player.message();
      ASSERT_EQ(answer.size(), call.answer.size());
      for (std::size_t i = 0; i < answer.size(); ++i) {
        const float allowed = same_compiler ? 0.0F : 1.0e-5F * std::abs(call.answer[i]) + 1.0e-6F;
        ASSERT_NEAR(answer[i], call.answer[i], allowed)
            << trace << ", call " << n << ", record " << i + 1
            << ": if the change is meant, record anew (tests/data/README.md)";
      }
      ++n;
    }
    EXPECT_GT(n, 200);
  }

  /// The columns of the master's own output file.
  std::map<std::string, std::vector<double>> output_of(const std::string& root) const {
    std::istringstream in(folder_.read(root + ".lac.csv"));
    std::vector<std::string> names;
    std::map<std::string, std::vector<double>> columns;
    for (std::string line; std::getline(in, line);) {
      std::istringstream cells(line);
      std::size_t column = 0;
      const bool header = names.empty();
      for (std::string cell; std::getline(cells, cell, ','); ++column) {
        if (header) {
          names.push_back(cell.substr(0, cell.find(' ')));
        } else {
          columns[names.at(column)].push_back(std::stod(cell));
        }
      }
    }
    return columns;
  }

  DisconLibrary master_ = DisconLibrary::open("liblac_wrapper", "DISCON", {LAC_LIBRARY_DIR});
  TempFolder folder_;
};

// The recordings hold what a host can do: a step that is a multiple of its own, a checkpoint
// between two steps, a restart without a first call, a lidar block.
TEST_F(OpenFastReplay, RecordingsHoldWhatTheyShould) {
  std::map<std::string, std::set<int>> statuses;
  for (const char* trace : {"feedback", "feedback.restart", "lidar"}) {
    for (const TraceCall& c : TraceReplay::read(kData + trace + ".lactrace")) {
      ASSERT_EQ(c.sent.size(), 3300U);
      ASSERT_TRUE(c.answered);
      statuses[trace].insert(static_cast<int>(c.sent[0]));
      EXPECT_EQ(c.sent[kFirstLidarRecord - 5], std::string(trace) == "lidar" ? 3.0F : 0.0F);
    }
  }
  EXPECT_EQ(statuses["feedback"], (std::set{-8, -1, 0, 1}));
  EXPECT_EQ(statuses["feedback.restart"], (std::set{-9, -1, 1}));
  EXPECT_EQ(statuses["lidar"], (std::set{-1, 0, 1}));
}

// Feedback only, with a checkpoint on the way; then the process that continued from it, here from
// the checkpoint that the first part has just written.
TEST_F(OpenFastReplay, FeedbackChainWithRestart) {
  TraceReplay player = replay(kData + "wrapper_feedback.IN", "NREL5MW");
  expect_as_recorded(player, "feedback.lactrace");
  expect_as_recorded(player, "feedback.restart.lactrace");
}

// What OpenFAST itself got from the two processes: the continued one gave the demands of the one
// that went on, from the checkpoint to the end.
TEST_F(OpenFastReplay, RestartedRunWasTheSame) {
  const std::vector<TraceCall> whole = TraceReplay::read(kData + "feedback.lactrace");
  const std::vector<TraceCall> rest = TraceReplay::read(kData + "feedback.restart.lactrace");
  ASSERT_GT(whole.size(), rest.size());
  for (std::size_t n = 1; n < rest.size(); ++n) {  // 0 is the restart itself
    const TraceCall& other = whole[whole.size() - rest.size() + n];
    ASSERT_EQ(rest[n].sent[1], other.sent[1]);
    for (const int record : {42, 43, 44, 45, 47}) {
      ASSERT_EQ(rest[n].answer[static_cast<std::size_t>(record) - 1],
                other.answer[static_cast<std::size_t>(record) - 1])
          << rest[n].sent[1] << " s";
    }
  }
}

TEST_F(OpenFastReplay, LidarChain) {
  TraceReplay player = replay(kData + "wrapper_lidar.IN", "NREL5MW");
  expect_as_recorded(player, "lidar.lactrace");
  ASSERT_FALSE(HasFailure());
  auto output = output_of("NREL5MW");
  EXPECT_EQ(output["FeedforwardActive"].back(), 1.0);
}

/// OpenFAST shows a new value b after a as a + 3 (b - a), a, b, b ... : the first two become b.
/// Gives the largest change made.
float hold_true_values(std::vector<TraceCall>& calls, std::size_t record) {
  float largest = 0.0F;
  const auto sent = [&](std::size_t n) -> float& { return calls[n].sent[record - 1]; };
  for (std::size_t n = 2; n + 2 < calls.size(); ++n) {
    if (sent(n) == sent(n - 1) || sent(n - 1) != sent(n - 2)) continue;
    largest = std::max(largest, std::abs(sent(n) - sent(n + 2)));
    sent(n) = sent(n + 1) = sent(n + 2);
  }
  return largest;
}

// The time extrapolation of the lidar values is undone: the chain sees the rotor-effective wind
// speed that it sees when the host sends every measurement as it is (and LDP takes it so), to the
// precision of the floats, in the same step. As sent, values overshoot by more than 5 m/s.
TEST_F(OpenFastReplay, ExtrapolationIsUndone) {
  std::vector<TraceCall> calls = TraceReplay::read(kData + "lidar.lactrace");
  TraceReplay as_sent = replay(kData + "wrapper_lidar.IN", "sent");
  for (const TraceCall& c : calls) as_sent.play(c);

  float overshoot = 0.0F;
  for (int value = 0; value < kLidarValues; ++value) {
    const float change =
        hold_true_values(calls, static_cast<std::size_t>(kFirstLidarRecord + value));
    if (value < kGates) overshoot = std::max(overshoot, change);
  }
  EXPECT_GT(overshoot, 5.0F);

  std::ifstream ldp(kData + "ldp.IN");
  std::ostringstream no_order;
  for (std::string line; std::getline(ldp, line);) {
    no_order << (line.find("! InterpolationOrder") != std::string::npos ? "0 ! InterpolationOrder -"
                                                                        : line)
             << '\n';
  }
  folder_.write("ldp.IN", no_order.str());
  for (const char* file : {"ffp.IN", "feedback.IN", "wrapper_lidar.IN"}) {
    std::filesystem::copy_file(kData + file, folder_.path() / file);
  }
  TraceReplay as_true = replay(folder_.file("wrapper_lidar.IN"), "true");
  for (const TraceCall& c : calls) {
    as_true.play(c);
    ASSERT_GE(as_true.fail(), 0) << as_true.message();
  }
  auto got = output_of("sent"), expected = output_of("true");
  ASSERT_EQ(got["LidarRews"].size(), expected["LidarRews"].size());
  EXPECT_EQ(got["LidarRewsValid"], expected["LidarRewsValid"]);
  for (std::size_t n = 0; n < got["LidarRews"].size(); ++n) {
    if (got["LidarRewsValid"][n] == 0.0) continue;
    ASSERT_NEAR(got["LidarRews"][n], expected["LidarRews"][n], 2.0e-5) << "row " << n;
  }
  EXPECT_GT(std::ranges::count(got["LidarRewsValid"], 1.0), 900);
}

}  // namespace
}  // namespace lac::test
