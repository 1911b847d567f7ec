// SPDX-License-Identifier: Apache-2.0
// Secondaries with static data (toy_static counts its calls in one, and refuses a second first call
// in one image): every turbine and every run has an image of its own.
#include <csignal>
#include <thread>

#include "support/environment.hpp"
#include "support/process_state.hpp"
#include "wrapper/chain_fixture.hpp"

#if !defined(_WIN32)
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace lac::test {
namespace {

using testing::HasSubstr;

class OwnImages : public ChainTest {
 protected:
  /// Turbines that differ in their root names only.
  std::vector<std::unique_ptr<TestHost>> farm(int turbines, const std::string& in_file) {
    std::vector<std::unique_ptr<TestHost>> hosts;
    for (int t = 0; t < turbines; ++t) {
      hosts.push_back(std::make_unique<TestHost>(master.entry(), in_file,
                                                 folder.file("T" + std::to_string(t) + ".SrvD")));
    }
    return hosts;
  }
  std::string counter() { return write_chain({{"c", "toy_static", "", ""}}); }

  /// A whole run; gives the torque demand of the last step, the number of calls if it is alone.
  static float fly(TestHost& host, int steps) {
    EXPECT_EQ(host.call(0), 0) << host.message();
    for (int i = 0; i < steps; ++i) EXPECT_EQ(host.call(1), 0) << host.message();
    return host.get(Rec::TorqueDemand);
  }
};

// Many turbines, step by step in turn in one thread, each as often as its number says.
TEST_F(OwnImages, TurbinesInTurn) {
  constexpr int kTurbines = 32;  // more than there are link namespaces
  const auto hosts = farm(kTurbines, counter());
  for (const auto& host : hosts) ASSERT_EQ(host->call(0), 0) << host->message();
  for (int step = 1; step <= kTurbines; ++step) {
    for (int t = step - 1; t < kTurbines; ++t) {
      TestHost& host = *hosts[static_cast<std::size_t>(t)];
      ASSERT_EQ(host.call(1), 0) << host.message();
      EXPECT_EQ(host.get(Rec::TorqueDemand), static_cast<float>(step + 1));
    }
  }
}

// Eight turbines in eight threads, starts and ends at any time, three runs each.
TEST_F(OwnImages, TurbinesInThreads) {
  constexpr int kTurbines = 8;
  const auto hosts = farm(kTurbines, counter());
  std::vector<std::thread> threads;
  for (int t = 0; t < kTurbines; ++t) {
    threads.emplace_back([&, t] {
      TestHost& host = *hosts[static_cast<std::size_t>(t)];
      for (int run = 0; run < 3; ++run) {
        EXPECT_EQ(fly(host, 100 * (t + 1)), static_cast<float>(100 * (t + 1) + 1));
        EXPECT_EQ(host.call(-1), 0);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// Two secondaries of one library in one chain do not meet either.
TEST_F(OwnImages, TwiceInOneChain) {
  TestHost host = host_for(write_chain({{"a", "toy_static", "", ""}, {"b", "toy_static", "", ""}}));
  EXPECT_EQ(fly(host, 5), 6.0f);
}

// A library that the input file calls reentrant is shared; this one is not, and says so.
TEST_F(OwnImages, ReentrantByTheInputFile) {
  const auto hosts = farm(2, write_chain({{"c", "toy_static", "", ""}},
                                         "\"C\" ! ReentrantSecondaries - one image for all\n"));
  ASSERT_EQ(hosts[0]->call(0), 0) << hosts[0]->message();
  EXPECT_TRUE(is_loaded(toy("toy_static")));
  EXPECT_EQ(hosts[1]->call(0), -1);
  EXPECT_THAT(hosts[1]->message(),
              HasSubstr("c (libtoy_static" LAC_LIBRARY_SUFFIX "): already loaded"));
  EXPECT_EQ(hosts[0]->call(1), 0);
  EXPECT_EQ(hosts[0]->get(Rec::TorqueDemand), 3.0f);
}

TEST_F(OwnImages, ReentrantOfUnknownName) {
  TestHost host =
      host_for(write_chain({{"count", "toy_static", "", ""}}, "coumt ! ReentrantSecondaries -\n"));
  EXPECT_EQ(host.call(0), -1);
  EXPECT_THAT(host.message(), HasSubstr("chain.IN:3: ReentrantSecondaries: found 'coumt', which is "
                                        "the name of no Secondary_n (did you mean 'count'?)"));
}

// A first call that fails removes the image as well.
TEST_F(OwnImages, FailedFirstCall) {
  const auto in = write_chain({{"c", "toy_static", "", ""}, {"f", "toy_script", "fail 0 no", ""}});
  const int before = loaded_libraries();
  for (int i = 0; i < 3; ++i) {
    TestHost host = host_for(in);
    EXPECT_EQ(host.call(0), -1);
    EXPECT_THAT(host.message(), HasSubstr("f (libtoy_script" LAC_LIBRARY_SUFFIX "): no"));
  }
  EXPECT_EQ(loaded_libraries(), before);
}

// Without a temporary folder the copy lies for a moment where the library lies.
TEST_F(OwnImages, WithoutATemporaryFolder) {
  const OtherTemporaryFolder nowhere(folder.path("no"));
  std::filesystem::create_directory(folder.path("lib"));
  std::filesystem::copy(toy("toy_static"), folder.path("lib"));
  const std::filesystem::path library =
      folder.path("lib") / std::filesystem::path(toy("toy_static")).filename();
  TestHost host = host_for(write_chain({{"c", library.string(), "", ""}}));
  EXPECT_EQ(fly(host, 3), 4.0f);
  host.call(-1);
  const std::filesystem::directory_iterator left(folder.path("lib"));
  EXPECT_EQ(std::distance(begin(left), end(left)), 1);
}

#if !defined(_WIN32)

// The temporary folder is empty while a run goes on, and so after the host was killed.
TEST_F(OwnImages, NothingIsLeftByAKilledHost) {
  const TempFolder temporary;
  const OtherTemporaryFolder here(temporary.path());
  const std::string in = counter();
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    const auto hosts = farm(4, in);
    bool good = true;
    for (const auto& host : hosts) good = host->call(0) == 0 && host->call(1) == 0 && good;
    const char answer = good ? 'y' : 'n';
    if (write(ready[1], &answer, 1) == 1) pause();
    _exit(1);
  }
  char answer = '?';
  ASSERT_EQ(read(ready[0], &answer, 1), 1);
  EXPECT_EQ(answer, 'y');
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  close(ready[0]), close(ready[1]);
  EXPECT_TRUE(std::filesystem::is_empty(temporary.path()));
}

#endif

}  // namespace
}  // namespace lac::test
