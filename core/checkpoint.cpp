// SPDX-License-Identifier: Apache-2.0
#include "core/checkpoint.hpp"

#include <cstring>
#include <fstream>
#include <iterator>
#include <span>

#include "core/error.hpp"
#include "core/part_file.hpp"

namespace lac {
namespace {

constexpr char kMagic[8] = {'L', 'A', 'C', 'C', 'H', 'K', 'P', '1'};  // last: format version

std::uint64_t fnv1a(std::span<const std::byte> data) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const std::byte b : data) {
    hash ^= static_cast<std::uint64_t>(b);
    hash *= 1099511628211ull;
  }
  return hash;
}

class Writer {
 public:
  void raw(const void* data, std::size_t n) {
    const auto* p = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), p, p + n);
  }
  void sized(const void* data, std::size_t n) {
    const std::uint64_t size = n;
    raw(&size, sizeof size);
    raw(data, n);
  }
  std::vector<std::byte> bytes;
};

class Reader {
 public:
  Reader(std::span<const std::byte> source, std::string file)
      : source_(source), file_(std::move(file)) {}

  void raw(void* data, std::size_t n) {
    if (n > source_.size()) throw Error(file_ + ": checkpoint is damaged: it ends too early");
    std::memcpy(data, source_.data(), n);
    source_ = source_.subspan(n);
  }
  template <class Container>
  Container sized() {
    std::uint64_t size = 0;
    raw(&size, sizeof size);
    if (size > source_.size()) throw Error(file_ + ": checkpoint is damaged: it ends too early");
    Container c(static_cast<std::size_t>(size), typename Container::value_type{});
    raw(c.data(), c.size());
    return c;
  }

 private:
  std::span<const std::byte> source_;
  std::string file_;
};

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& c) {
  Writer w;
  w.raw(kMagic, sizeof kMagic);
  w.sized(c.module.data(), c.module.size());
  w.sized(c.input_file.data(), c.input_file.size());
  w.sized(c.out_name.data(), c.out_name.size());
  w.raw(&c.time_step_s, sizeof c.time_step_s);
  w.raw(&c.steps, sizeof c.steps);
  w.sized(c.state.data(), c.state.size());
  const std::uint64_t sum = fnv1a(w.bytes);
  w.raw(&sum, sizeof sum);

  PartFile out(file);
  out.write(w.bytes.data(), w.bytes.size());
  out.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& file, const std::string& module) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(file.string() + ": cannot open the checkpoint");
  const std::vector<char> chars{std::istreambuf_iterator<char>(in), {}};
  const auto all = std::as_bytes(std::span(chars));
  if (all.size() < sizeof kMagic + sizeof(std::uint64_t) ||
      std::memcmp(all.data(), kMagic, sizeof kMagic - 1) != 0) {
    throw Error(file.string() + ": is not a checkpoint of LAC Chain");
  }
  if (static_cast<char>(all[sizeof kMagic - 1]) != kMagic[sizeof kMagic - 1]) {
    throw Error(file.string() + ": checkpoint format " +
                std::string(1, static_cast<char>(all[sizeof kMagic - 1])) + ", expected " +
                std::string(1, kMagic[sizeof kMagic - 1]) +
                ": restart with the version that wrote it");
  }
  const auto body = all.first(all.size() - sizeof(std::uint64_t));
  std::uint64_t sum = 0;
  std::memcpy(&sum, all.data() + body.size(), sizeof sum);
  if (sum != fnv1a(body)) throw Error(file.string() + ": checkpoint is damaged: wrong check sum");

  Reader r(body.subspan(sizeof kMagic), file.string());
  Checkpoint c;
  c.module = r.sized<std::string>();
  c.input_file = r.sized<std::string>();
  c.out_name = r.sized<std::string>();
  r.raw(&c.time_step_s, sizeof c.time_step_s);
  r.raw(&c.steps, sizeof c.steps);
  c.state = r.sized<std::vector<std::byte>>();
  if (c.module != module) {
    throw Error(file.string() + ": checkpoint of '" + c.module + "', expected '" + module + "'");
  }
  return c;
}

}  // namespace lac
