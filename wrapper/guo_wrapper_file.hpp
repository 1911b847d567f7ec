// SPDX-License-Identifier: Apache-2.0
// The WRAPPER.IN of Guo's chain, read unchanged. docs/hosts/guo.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/guo_input_file.hpp"
#include "core/notice.hpp"
#include "wrapper/chain_config.hpp"

namespace lac {

/// One SubDLLName with its SubDLLInputName.
struct GuoSubDll {
  int line = 0;         // of SubDLLName
  std::string written;  // SubDLLName as it stands
  std::string name;     // for messages and file names: its stem, with a number if it is not alone
  std::string library;  // what the master is to open
  std::string input_file;  // as written, or absolute if it lies in the working folder only
  bool replaced = false;   // `library` is one of ours
};

/// Form with room for the keys of our master that may stand behind theirs (GuoInputFile extras).
GuoForm guo_wrapper_form(int libraries);

/// All of them, in the order of calls. Names are searched in the folder of the file, then in the
/// working folder, as theirs; `\` counts as `/`. Libraries: with the ending of this system, also
/// with `lib` in front. One that is not there but has an LDP or FFP input file of their form is
/// replaced by liblac_ldp or liblac_ffp. Precondition: file.is_theirs(guo_wrapper_marks()).
/// Throws lac::Error.
std::vector<GuoSubDll> read_guo_sub_dlls(const GuoInputFile& file);

/// The row `"name" "library" "input file" ! Secondary_n` that says the same.
std::string secondary_row(const GuoSubDll& sub_dll, int number);

/// The chain of a WRAPPER.IN: LidarLayout guo unless a line behind theirs says otherwise. Nothing
/// if the file is of our own form. Tells in `notice` which libraries were replaced by ours. Throws
/// lac::Error as WrapperParams::read does.
std::optional<WrapperParams> read_guo_wrapper_file(const std::filesystem::path& file,
                                                   Notice& notice);

}  // namespace lac
