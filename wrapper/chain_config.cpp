// SPDX-License-Identifier: Apache-2.0
#include "wrapper/chain_config.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/suggest.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

/// The secondaries that a row of names means; a name that none has is an error.
std::vector<SecondaryParams*> named_secondaries(InputFile& in, const std::string& key,
                                                std::vector<SecondaryParams>& all) {
  std::vector<SecondaryParams*> found;
  if (!in.has(key)) return found;
  for (const std::string& name : in.texts(key)) {
    const auto same = [&](const SecondaryParams& s) { return equal_ignoring_case(s.name, name); };
    const auto s = std::ranges::find_if(all, same);
    if (s == all.end()) {
      std::vector<std::string> names;
      for (const SecondaryParams& o : all) names.push_back(o.name);
      in.fail(key, "found '" + name + "', which is the name of no Secondary_n" +
                       did_you_mean(name, names));
    }
    found.push_back(&*s);
  }
  return found;
}

/// Those that get a lidar block of Guo's layout. OpenFAST's lidar says too little by itself: the
/// keys that our own libraries need to read it stand in the master's file then.
void read_guo_secondaries(InputFile& in, WrapperParams& p) {
  const auto named = named_secondaries(in, "GuoSecondaries", p.secondaries);
  for (SecondaryParams* s : named) s->guo = true;
  if (named.empty()) return;
  if (p.lidar == HostLidar::None) {
    in.fail("GuoSecondaries", "needs a lidar, and LidarLayout is none");
  }
  if (p.lidar == HostLidar::OpenFast) p.openfast_lidar = OpenFastLidarParams::read(in);
}

}  // namespace

WrapperParams WrapperParams::read(InputFile& in) {
  WrapperParams p;
  p.file = in.path();
  p.secondaries = SecondaryParams::read_all(in);
  for (SecondaryParams* s : named_secondaries(in, "ReentrantSecondaries", p.secondaries)) {
    s->reentrant = true;
  }
  p.signals = NamedSignal::read_all(in);
  p.lidar =
      static_cast<HostLidar>(in.choice("LidarLayout", 0, {"none", "native", "guo", "openfast"}));
  read_guo_secondaries(in, p);
  p.extended_demands = in.flag("ExtendedDemands", false);
  if (in.has("SharedRecords")) {
    for (const std::string& word : in.texts("SharedRecords")) {
      p.shared_records.push_back(
          OutputParams::find_channel(in, "SharedRecords", word, p.signals).record);
    }
  }
  p.output = OutputParams::read(in, p.signals);
  in.finish();
  return p;
}

DisconLibrary WrapperParams::open_library(const SecondaryParams& secondary,
                                          const fs::path& wrapper_folder,
                                          const fs::path& run_folder) const {
  const std::vector<fs::path> folders{file.parent_path(), wrapper_folder};
  try {
    if (secondary.reentrant) {
      return DisconLibrary::open(secondary.library, secondary.entry, folders);
    }
    return DisconLibrary::open_own(secondary.library, secondary.entry, folders, {run_folder});
  } catch (const Error& e) {
    throw Error(secondary.where + ": " + e.what());
  }
}

}  // namespace lac
