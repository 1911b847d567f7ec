// SPDX-License-Identifier: Apache-2.0
// The probe: a DISCON library between a host and a controller that changes nothing and writes every
// call into a trace. It takes the place of discon_entry.cpp in its library: a probe must see calls
// as they come, not as the life-cycle says.
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/call_strings.hpp"
#include "core/discon_entry.hpp"
#include "core/discon_library.hpp"
#include "core/error.hpp"
#include "core/input_file.hpp"
#include "core/native_path.hpp"
#include "tools/host_probe/host_trace.hpp"

namespace lac {
namespace fs = std::filesystem;
namespace {

struct Call {
  SwapView swap;
  int* fail;
  const char* in_file;
  char* out_name;
  char* message;

  std::string in_file_text() const { return std::string(read_in_file(in_file, swap)); }
  std::string out_name_text() const { return std::string(read_out_name(out_name, swap)); }
  bool names_checkpoint() const {
    const int status = swap.integer(Rec::Status, LAC_STATUS_STEP);
    return status == LAC_STATUS_CHECKPOINT || status == LAC_STATUS_RESTART;
  }
};

class Probe {
 public:
  /// Reads the probe's own input file. Throws lac::Error.
  Probe(const std::string& in_file, const Call& call, const char* trace_ending)
      : own_in_file_(in_file), records_(call.swap.size()) {
    InputFile in = InputFile::load(path_from_bytes(in_file));
    const fs::path input = in.resolve(in.text("ControllerInput"));
    const std::string library = in.text("Controller");
    const std::string entry = in.text("ControllerEntry", "DISCON");
    fs::path trace = in.text("TraceFile", "");
    in.finish();
    if (!std::ifstream(input)) in.fail("ControllerInput", input.string() + " cannot be opened");
    controller_in_file_ = bytes_from_path(input);
    const fs::path root = path_from_bytes(call.out_name_text());
    if (trace.empty()) trace = root.stem().empty() ? fs::path("host") : root.stem();
    if (trace.is_relative()) trace = root.parent_path() / trace;
    controller_ = DisconLibrary::open_own(library, entry, {in.path().parent_path(), own_folder()},
                                          {in.path().parent_path()});
    trace += trace_ending;
    writer_ = std::make_unique<TraceWriter>(trace, records_);
  }

  void forward(Call& call) {
    const float length_from_host = call.swap.data()[static_cast<int>(Rec::InFileLength) - 1];
    writer_->sent(call.swap.data(), *call.fail, call.in_file_text(), call.out_name_text());
    const char* in_file = call.in_file;
    if (!call.names_checkpoint()) {
      in_file = controller_in_file_.c_str();
      call.swap.set(Rec::InFileLength, static_cast<double>(controller_in_file_.size() + 1));
    }
    controller_.entry()(call.swap.data(), call.fail, in_file, call.out_name, call.message);
    call.swap.set(Rec::InFileLength, static_cast<double>(length_from_host));
    const int capacity = call.swap.integer(Rec::MessageCapacity, 0);
    writer_->answered(call.swap.data(), *call.fail,
                      *call.fail != 0 ? read_string(call.message, capacity) : std::string_view{});
  }

  const std::string& own_in_file() const { return own_in_file_; }

 private:
  std::string own_in_file_;
  std::string controller_in_file_;
  int records_;
  DisconLibrary controller_;
  std::unique_ptr<TraceWriter> writer_;
};

/// One per turbine, by the root name of its files.
std::map<std::string, std::unique_ptr<Probe>> probes;
std::mutex door;

Probe* find(const std::string& out_name) {
  const std::lock_guard lock(door);
  const auto found = probes.find(out_name);
  return found == probes.end() ? nullptr : found->second.get();
}
Probe* keep(const std::string& out_name, std::unique_ptr<Probe> probe) {
  const std::lock_guard lock(door);
  probes[out_name].reset();  // a run that was never ended: its files are closed first
  return (probes[out_name] = std::move(probe)).get();
}
void drop(const std::string& out_name) {
  const std::lock_guard lock(door);
  probes.erase(out_name);
}

/// A restarted process is told the name of the checkpoint alone: the probe's own input file stands
/// in a small file beside it.
fs::path beside(const std::string& checkpoint) {
  return path_from_bytes(checkpoint + ".probe");
}

std::unique_ptr<Probe> begin(int status, const Call& call) {
  if (status == LAC_STATUS_FIRST) {
    return std::make_unique<Probe>(call.in_file_text(), call, ".lactrace");
  }
  std::string own_in_file;
  std::getline(std::ifstream(beside(call.in_file_text())), own_in_file);
  return std::make_unique<Probe>(own_in_file, call, ".restart.lactrace");
}

void dispatch(Call& call) {
  const int status = call.swap.integer(Rec::Status, LAC_STATUS_STEP);
  const std::string out_name = call.out_name_text();
  Probe* probe = status == LAC_STATUS_FIRST || status == LAC_STATUS_RESTART
                     ? keep(out_name, begin(status, call))
                     : find(out_name);
  if (probe == nullptr) {
    if (status == LAC_STATUS_LAST) return;  // after a first call that failed
    throw Error("call with status " + std::to_string(status) + " before a first one");
  }
  if (status == LAC_STATUS_CHECKPOINT) {
    std::ofstream(beside(call.in_file_text())) << probe->own_in_file() << '\n';
  }
  probe->forward(call);
  if (status == LAC_STATUS_LAST) drop(out_name);
}

}  // namespace

void discon_entry(float* array, int* fail, const char* in_file, const char* out_name,
                  char* message) noexcept {
  Call call{{array, known_array_size(array)}, fail, in_file, const_cast<char*>(out_name), message};
  try {
    dispatch(call);
  } catch (const std::exception& e) {
    *fail = -1;
    write_string(message, call.swap.integer(Rec::MessageCapacity, 0),
                 std::string("host_probe: ") + e.what());
  }
}

}  // namespace lac
