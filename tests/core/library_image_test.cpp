// SPDX-License-Identifier: Apache-2.0
// Several images of one library in one process. Toys: static data (toy_static), a library found by
// a search path that counts from the toy's own folder (toy_whole), start-up code that dies.
#include "core/library_image.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/discon_library.hpp"
#include "core/error.hpp"
#include "support/environment.hpp"
#include "support/error_text.hpp"
#include "support/library_names.hpp"
#include "support/process_state.hpp"
#include "support/temp_folder.hpp"

#if !defined(_WIN32)
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#endif

namespace lac::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

fs::path toy(const std::string& name) {
  return fs::path(LAC_TOY_DIR) / ("lib" + name + LAC_LIBRARY_SUFFIX);
}

LibraryImage open_shared(const std::string& name) {
  std::string reason;
  LibraryImage image = LibraryImage::open(toy(name), reason);
  EXPECT_TRUE(image) << reason;
  return image;
}

/// One call of status 1 or 0; gives the torque demand.
float call(const LibraryImage& image, float status = 1.0f) {
  std::vector<float> array(200);
  array[0] = status;
  array[48] = 100.0f;
  std::vector<char> message(100), text(100);
  int fail = 0;
  reinterpret_cast<LacDisconFunction>(image.symbol("DISCON"))(array.data(), &fail, text.data(),
                                                              text.data(), message.data());
  return array[46];
}

int files_in(const fs::path& folder) {
  const fs::recursive_directory_iterator all(folder, fs::directory_options::skip_permission_denied);
  return static_cast<int>(std::distance(begin(all), end(all)));
}

// Each image counts its own calls, in whatever order they come, and goes on without the original.
TEST(LibraryImage, CopiesHaveDataOfTheirOwn) {
  std::vector<LibraryImage> copies;
  {
    const LibraryImage shared = open_shared("toy_static");
    call(shared);
    for (int i = 0; i < 30; ++i) copies.push_back(LibraryImage::open_copy(toy("toy_static"), {}));
    EXPECT_EQ(call(shared), 2.0f);
  }
  EXPECT_FALSE(is_loaded(toy("toy_static")));
  for (int step = 1; step <= 5; ++step) {
    for (const LibraryImage& copy : copies) EXPECT_EQ(call(copy), static_cast<float>(step));
  }
  for (std::size_t i = 1; i < copies.size(); ++i) {
    EXPECT_NE(copies[i].symbol("DISCON"), copies[i - 1].symbol("DISCON"));
  }
}

// Closed, a copy is gone from memory.
TEST(LibraryImage, CopiesAreUnloaded) {
  const LibraryImage shared = open_shared("toy_static");
  const int before = loaded_libraries();
  for (int i = 0; i < 20; ++i) {
    const LibraryImage copy = LibraryImage::open_copy(toy("toy_static"), {});
    EXPECT_GT(loaded_libraries(), before);
  }
  EXPECT_EQ(loaded_libraries(), before);
}

// The copy lies elsewhere; what it is linked to is found all the same, and stays.
TEST(LibraryImage, RelativeSearchPath) {
  LibraryImage copy;
  {
    const LibraryImage shared = open_shared("toy_whole");
    copy = LibraryImage::open_copy(toy("toy_whole"), {});
  }
  EXPECT_FALSE(is_loaded(toy("toy_whole")));
  EXPECT_EQ(call(copy), 2.0f);
  EXPECT_EQ(call(copy), 4.0f);
}

// Nothing stays in the temporary folder: on Windows from the end of the image on.
TEST(LibraryImage, FilesAreRemoved) {
  const TempFolder temporary;
  const OtherTemporaryFolder here(temporary.path());
  {
    const LibraryImage shared = open_shared("toy_static");
    const LibraryImage copy = LibraryImage::open_copy(toy("toy_static"), {});
#if !defined(_WIN32)
    EXPECT_EQ(files_in(temporary.path()), 0);
#endif
  }
  EXPECT_EQ(files_in(temporary.path()), 0);
}

// Without a temporary folder the others are tried in their order.
TEST(LibraryImage, SecondPlace) {
  const TempFolder second;
  const OtherTemporaryFolder here(second.path() / "no");
  const LibraryImage shared = open_shared("toy_static");
  const LibraryImage copy =
      LibraryImage::open_copy(toy("toy_static"), {second.path() / "not", second.path()});
  EXPECT_EQ(call(copy), 1.0f);
  const std::string text =
      error_text([&] { LibraryImage::open_copy(toy("toy_static"), {second.path() / "not"}); });
  EXPECT_THAT(text, AllOf(HasSubstr("cannot be copied to give it static data of its own; tried:"),
                          HasSubstr("\n  the system's temporary folder: "),
                          HasSubstr("\n  " + (second.path() / "not").string() + ": No such file")));
}

#if !defined(_WIN32)

/// Files may not grow beyond so many bytes while this lives, as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { setrlimit(RLIMIT_FSIZE, &old_); }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit old_{};
};

// A disk without room: told, and nothing of the attempt stays.
TEST(LibraryImage, NoRoom) {
  const TempFolder temporary;
  const OtherTemporaryFolder here(temporary.path());
  const LibraryImage shared = open_shared("toy_static");
  std::string text;
  {
    const SmallDisk full(1000);
    text = error_text([&] { LibraryImage::open_copy(toy("toy_static"), {temporary.path()}); });
  }
  EXPECT_THAT(text, HasSubstr("\n  " + temporary.path().string() + ": File too large"));
  EXPECT_EQ(files_in(temporary.path()), 0);
}

/// A mounted folder where files can be made and not executed; empty if this system has none.
fs::path folder_without_programs() {
  std::ifstream mounts("/proc/mounts");
  std::string device, where, type, options;
  while (mounts >> device >> where >> type >> options && mounts.ignore(1000, '\n')) {
    const bool for_files = type == "tmpfs" || type.starts_with("ext") || type == "xfs";
    if (for_files && options.find("noexec") != std::string::npos &&
        access(where.c_str(), W_OK | X_OK) == 0 && options.starts_with("rw")) {
      return where;
    }
  }
  return {};
}

// There: the next place is taken, and if there is none the loader's words are told.
TEST(LibraryImage, NoPrograms) {
  const fs::path no_programs = folder_without_programs();
  if (no_programs.empty()) GTEST_SKIP() << "no file system here is mounted without programs";
  const TempFolder second;
  const OtherTemporaryFolder here(no_programs);
  const int before = files_in(no_programs);
  const LibraryImage shared = open_shared("toy_static");
  const LibraryImage copy = LibraryImage::open_copy(toy("toy_static"), {second.path()});
  EXPECT_EQ(call(copy), 1.0f);
  EXPECT_THAT(
      error_text([&] { LibraryImage::open_copy(toy("toy_static"), {}); }),
      AllOf(HasSubstr("\n  " + no_programs.string() + ": "), HasSubstr("failed to map segment")));
  EXPECT_EQ(files_in(no_programs), before);
}

// What a process left that was ended while it loaded a copy goes when the next copy is made; what
// belongs to a process that runs, is new, or has another name stays.
TEST(LibraryImage, LeftBehindByACrash) {
  const TempFolder temporary;
  const OtherTemporaryFolder here(temporary.path());
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  const std::string ended = "lac_image_" + std::to_string(child) + "_";
  const std::string running = "lac_image_" + std::to_string(getpid()) + "_a";
  const auto hour_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  for (const std::string& name : {ended + "old", ended + "new", running, std::string("other")}) {
    fs::create_directory(temporary.path(name));
    temporary.write(name + "/libx.so", "x");
    if (name != ended + "new") fs::last_write_time(temporary.path(name), hour_ago);
  }
  const LibraryImage shared = open_shared("toy_static");
  const LibraryImage copy = LibraryImage::open_copy(toy("toy_static"), {});
  EXPECT_FALSE(fs::exists(temporary.path(ended + "old")));
  EXPECT_TRUE(fs::exists(temporary.path(ended + "new")));
  EXPECT_TRUE(fs::exists(temporary.path(running)));
  EXPECT_TRUE(fs::exists(temporary.path("other")));
}

// Start-up code that aborts or throws ends the process; the last words name the library.
TEST(LibraryImageDeathTest, CrashOnLoad) {
  for (const char* name : {"toy_aborts_on_load", "toy_throws_on_load"}) {
    std::string reason;
    EXPECT_DEATH(LibraryImage::open(toy(name), reason),
                 "LAC Chain: the process ended while it loaded .*lib" + std::string(name) +
                     ".*start-up code");
  }
}

#endif

// A library whose own library is missing is refused with the name of that.
TEST(LibraryImage, MissingPart) {
  const std::string text =
      error_text([] { DisconLibrary::open(toy("toy_orphan").string(), "DISCON", {}); });
  EXPECT_THAT(text, HasSubstr(toy("toy_orphan").string() + ": cannot be loaded: "));
  EXPECT_THAT(text, testing::Not(HasSubstr("this process is")));  // the machine is the right one
#if !defined(_WIN32)                                              // whose loader does not say which
  EXPECT_THAT(text, HasSubstr("libtoy_orphan_part.so"));
#endif
}

// The mark of a reentrant library (toy_script) is believed, its absence as well.
TEST(LibraryImage, MarkDecides) {
  EXPECT_FALSE(
      DisconLibrary::open_own(toy("toy_script").string(), "DISCON", {}, {}).has_own_image());
  const DisconLibrary own = DisconLibrary::open_own(toy("toy_static").string(), "DISCON", {}, {});
  EXPECT_TRUE(own.has_own_image());
  EXPECT_EQ(own.path(), toy("toy_static"));
  EXPECT_FALSE(is_loaded(toy("toy_static")));
}

}  // namespace
}  // namespace lac::test
