// Serves a simulator to an evaluation server over the simulator protocol.
//
// One header for C++17 and POSIX, with nothing but the standard library: copy it beside
// your program. A world derives from Simulator and calls serve:
//
//     int main() { World world; return proctor_simulator::serve(world); }
//
// serve(world, "unix:/run/world.sock") listens there, for one server after the other, in a
// program that you start yourself.
//
// A robot is a simulator whose benchmark has the member `physical`: derive it from Robot,
// and write `stop`, which this header calls when the server or its operator says so, when
// the connection ends, and when no message came for `watchdog_s`. It needs threads: some
// systems want -pthread.
//
// Standard output belongs to the protocol: while `serve` runs, what is printed goes to
// standard error. The protocol stands in spec/simulator.md.

#ifndef PROCTOR_SIMULATOR_HPP
#define PROCTOR_SIMULATOR_HPP

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace proctor_simulator {

constexpr int kProtocol = 1;

struct Member;
struct Value;
using Map = std::vector<Member>;
using List = std::vector<Value>;
using Numbers = std::vector<double>;
using NumbersByName = std::map<std::string, Numbers>;

// A value of MessagePack, as JSON has them; written as 1, 0.5, "text", List{…}, Map{{"a", 1}}.
struct Value {
  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, List, Map> content;
  Value(std::nullptr_t = nullptr) : content(nullptr) {}
  Value(bool value) : content(value) {}
  Value(int value) : content(std::int64_t{value}) {}
  Value(std::int64_t value) : content(value) {}
  Value(double value) : content(value) {}
  Value(const char* value) : content(std::string(value)) {}
  Value(std::string value) : content(std::move(value)) {}
  Value(List value) : content(std::move(value)) {}
  Value(Map value) : content(std::move(value)) {}
  inline Value(const Numbers& numbers);
  inline const Value& operator[](const std::string& name) const;
  template <typename T>
  const T& as() const {
    return std::get<T>(content);
  }
  double number() const {
    if (const auto* whole = std::get_if<std::int64_t>(&content)) return double(*whole);
    return std::get<double>(content);
  }
};

struct Member {
  std::string name;
  Value value;
};

inline Value::Value(const Numbers& numbers) : content(List(numbers.begin(), numbers.end())) {}

// The member of a map; null if there is none.
inline const Value& Value::operator[](const std::string& name) const {
  static const Value nothing;
  if (const auto* map = std::get_if<Map>(&content))
    for (const auto& member : *map)
      if (member.name == name) return member.value;
  return nothing;
}

// Throw it in `reset` for a task that can never be played.
struct Unplayable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Beginning {
  std::string instruction;
  NumbersByName state;
  std::vector<std::string> stages = {};  // what a graded score counts before the goal
};

namespace detail {

// Whether a class stands for a bool, as an element of std::vector<bool> does.
template <typename T, typename = void>
struct StandsForBool : std::false_type {};
template <typename T>
struct StandsForBool<T, std::void_t<decltype(std::declval<const T&>().operator bool())>>
    : std::is_convertible<const T&, bool> {};

// A bool and nothing that C++ would convert to one: the truth of a share such as 0.3, of a
// text or of a pointer would decide a score by chance. Compare a number: `share >= 1`.
struct OnlyBool {
  OnlyBool(bool value) : value(value) {}
  template <typename T, std::enable_if_t<StandsForBool<T>::value, int> = 0>
  OnlyBool(const T& one) : value(one) {}
  template <typename T, std::enable_if_t<!StandsForBool<T>::value, int> = 0>
  OnlyBool(T) = delete;
  bool value;
};

}  // namespace detail

// Takes a bool alone, and is read as one. No bool becomes a Truth by itself, so that
// `condition ? result.success : false` is a bool.
struct Truth {
  explicit Truth(detail::OnlyBool one) : value(one.value) {}
  Truth& operator=(detail::OnlyBool one) {
    value = one.value;
    return *this;
  }
  operator bool() const { return value; }
  bool value;
};

struct StepResult {
  StepResult() = default;
  StepResult(NumbersByName state, detail::OnlyBool success = false,
             detail::OnlyBool terminated = false, double reward = 0.0, double score = 0.0)
      : state(std::move(state)), success(success), terminated(terminated), reward(reward),
        score(score) {}

  NumbersByName state;
  Truth success{false};
  Truth terminated{false};
  double reward = 0.0;
  double score = 0.0;  // read where the benchmark is graded
};

// A world; the first three functions must be written.
class Simulator {
 public:
  virtual ~Simulator() = default;
  // The map `benchmark` of spec/simulator.md.
  virtual Value benchmark() = 0;
  virtual Beginning reset(const std::string& task, std::uint64_t seed,
                          const std::string& split) = 0;
  virtual StepResult step(const NumbersByName& action) = 0;
  // Write height × width × channels bytes, RGB, top row first.
  virtual void draw(const std::string& /*camera*/, int /*width*/, int /*height*/,
                    std::uint8_t* /*pixels*/) {
    throw std::logic_error("draw is not written");
  }
  // Bytes that are equal when the rest of the episode is decided equally.
  virtual std::string digest() { throw std::logic_error("digest is not written"); }
};

// A robot; `stop` ends every motion, and allows none before the next `reset`. Another
// thread calls it, also while `reset` or `step` is executed, and perhaps several times.
class Robot : public Simulator {
 public:
  virtual void stop() = 0;
};

// Adjacent numbers of one meaning; spec/conventions.md has the words.
inline Map part(int size, std::string quantity = "number", std::string unit = "1",
                std::string frame = "none", std::string rotation = "none",
                std::string relative_to = "none") {
  return {{"size", size}, {"quantity", std::move(quantity)}, {"unit", std::move(unit)},
          {"frame", std::move(frame)}, {"rotation", std::move(rotation)},
          {"relative_to", std::move(relative_to)}};
}

// A VectorSpace of named parts, one after the other. With bounds, numbers beyond them
// are executed as the nearest allowed ones.
inline Map vector(Map parts, Numbers minimum = {}, Numbers maximum = {}) {
  int size = 0;
  for (auto& [name, declared] : parts) {
    const int start = size;
    size += int(declared["size"].number());
    std::get<Map>(declared.content).push_back({"start", start});
  }
  Map space{{"size", size}, {"parts", std::move(parts)}};
  space.push_back({"out_of_range", minimum.empty() ? "unbounded" : "clip"});
  if (!minimum.empty()) {
    space.push_back({"minimum", minimum});
    space.push_back({"maximum", maximum});
  }
  return space;
}

// A VectorSpace of numbers that measure nothing.
inline Map numbers(int size, Numbers minimum = {}, Numbers maximum = {}) {
  return vector(Map{{"all", part(size)}}, std::move(minimum), std::move(maximum));
}

namespace detail {

class Writer {
 public:
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(4);  // its length stands first

  void map(std::size_t size) { head(0x80, 16, 0xde, size, 1); }
  void list(std::size_t size) { head(0x90, 16, 0xdc, size, 1); }
  void binary(std::size_t size) { head(0, 0, 0xc4, size, 0); }
  void text(const std::string& text) {
    head(0xa0, 32, 0xd9, text.size(), 0);
    bytes.insert(bytes.end(), text.begin(), text.end());
  }
  void truth(bool value) { bytes.push_back(value ? 0xc3 : 0xc2); }
  void number(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    bytes.push_back(0xcb);
    big_endian(bits, 8);
  }
  void integer(std::int64_t value) {
    bytes.push_back(0xd3);
    big_endian(static_cast<std::uint64_t>(value), 8);
  }
  void numbers(const NumbersByName& named) {
    map(named.size());
    for (const auto& [name, vector] : named) {
      text(name);
      list(vector.size());
      for (double value : vector) number(value);
    }
  }
  void value(const Value& value) {
    std::visit([this](const auto& content) { write(content); }, value.content);
  }
  // Room for `size` bytes, to be filled before the next call.
  std::uint8_t* room(std::size_t size) {
    binary(size);
    bytes.resize(bytes.size() + size);
    return bytes.data() + bytes.size() - size;
  }

 private:
  void write(std::nullptr_t) { bytes.push_back(0xc0); }
  void write(bool value) { truth(value); }
  void write(std::int64_t value) { integer(value); }
  void write(double value) { number(value); }
  void write(const std::string& value) { text(value); }
  void write(const List& values) {
    list(values.size());
    for (const auto& member : values) value(member);
  }
  void write(const Map& members) {
    map(members.size());
    for (const auto& member : members) {
      text(member.name);
      value(member.value);
    }
  }
  // first: the type with the shortest length, which is 2^least bytes long.
  void head(int fixed, std::size_t below, int first, std::size_t size, int least) {
    if (size < below) return bytes.push_back(static_cast<std::uint8_t>(fixed | int(size)));
    int width = least;
    while (width < 2 && size >> (8 << width)) ++width;
    bytes.push_back(static_cast<std::uint8_t>(first + width - least));
    big_endian(size, 1 << width);
  }
  void big_endian(std::uint64_t value, int size) {
    for (int shift = 8 * (size - 1); shift >= 0; shift -= 8)
      bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
};

class Reader {
 public:
  Reader(const std::uint8_t* begin, std::size_t size) : at_(begin), end_(begin + size) {}

  Value value() {
    const int kind = byte();
    if (kind < 0x80) return kind;
    if (kind >= 0xe0) return kind - 256;
    if (kind < 0x90) return map(kind & 15);
    if (kind < 0xa0) return list(kind & 15);
    if (kind < 0xc0) return text(kind & 31);
    switch (kind) {
      case 0xc0: return nullptr;
      case 0xc2: return false;
      case 0xc3: return true;
      case 0xc4: case 0xc5: case 0xc6: return text(big_endian(1 << (kind - 0xc4)));
      case 0xca: { auto bits = std::uint32_t(big_endian(4)); float f; std::memcpy(&f, &bits, 4); return double(f); }
      case 0xcb: { auto bits = big_endian(8); double d; std::memcpy(&d, &bits, 8); return d; }
      case 0xcc: case 0xcd: case 0xce: case 0xcf:
        return std::int64_t(big_endian(1 << (kind - 0xcc)));
      case 0xd0: return int(std::int8_t(big_endian(1)));
      case 0xd1: return int(std::int16_t(big_endian(2)));
      case 0xd2: return int(std::int32_t(big_endian(4)));
      case 0xd3: return std::int64_t(big_endian(8));
      case 0xd9: case 0xda: case 0xdb: return text(big_endian(1 << (kind - 0xd9)));
      case 0xdc: case 0xdd: return list(big_endian(2 << (kind - 0xdc)));
      case 0xde: case 0xdf: return map(big_endian(2 << (kind - 0xde)));
      default: throw std::runtime_error("MessagePack of an unknown kind");
    }
  }

 private:
  std::uint8_t byte() {
    if (at_ == end_) throw std::runtime_error("a request ends early");
    return *at_++;
  }
  std::uint64_t big_endian(int size) {
    std::uint64_t value = 0;
    while (size-- > 0) value = value << 8 | byte();
    return value;
  }
  std::string text(std::uint64_t size) {
    if (size > std::uint64_t(end_ - at_)) throw std::runtime_error("a request ends early");
    std::string read(reinterpret_cast<const char*>(at_), size);
    at_ += size;
    return read;
  }
  Value list(std::uint64_t size) {
    List values;
    while (size-- > 0) values.push_back(value());
    return values;
  }
  Value map(std::uint64_t size) {
    Map members;
    while (size-- > 0) {
      std::string name = value().as<std::string>();
      members.push_back({std::move(name), value()});
    }
    return members;
  }
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

inline bool read_all(int descriptor, std::uint8_t* place, std::size_t size) {
  while (size > 0) {
    const ssize_t got = ::read(descriptor, place, size);
    if (got <= 0) return false;
    place += got;
    size -= std::size_t(got);
  }
  return true;
}

// Memory of the server for pixels; it is mapped while its number stays the same.
class SharedMemory {
 public:
  ~SharedMemory() { unmap(); }
  void follow(const Value& offered) {
    if (!std::holds_alternative<Map>(offered.content)) return unmap();
    const double number = offered["number"].number();
    if (number == number_) return;
    unmap();
    number_ = number;
    const auto size = std::size_t(offered["size"].number());
    const int file = ::open(offered["path"].as<std::string>().c_str(), O_RDWR | O_CLOEXEC);
    struct stat status;
    if (file >= 0 && ::fstat(file, &status) == 0 && std::size_t(status.st_size) >= size) {
      void* mapped = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
      if (mapped != MAP_FAILED) bytes_ = static_cast<std::uint8_t*>(mapped), size_ = size;
    }
    if (file >= 0) ::close(file);
  }
  // Where `size` bytes belong; null where there is no such memory.
  std::uint8_t* place(const Value& offset, std::size_t size) const {
    if (!bytes_ || std::holds_alternative<std::nullptr_t>(offset.content)) return nullptr;
    const auto begin = std::size_t(offset.number());
    return begin <= size_ && size <= size_ - begin ? bytes_ + begin : nullptr;
  }

 private:
  void unmap() {
    if (bytes_) ::munmap(bytes_, size_);
    bytes_ = nullptr, size_ = 0, number_ = -1;
  }
  std::uint8_t* bytes_ = nullptr;
  std::size_t size_ = 0;
  double number_ = -1;
};

// Stops a robot in time, whatever the rest of the program does. A thread reads all that the
// server sends; requests other than a stop wait for the main thread.
class StopGuard {
 public:
  StopGuard(Robot& robot, const Value& benchmark, int descriptor)
      : robot_(robot), descriptor_(descriptor),
        watchdog_s_(benchmark["physical"]["watchdog_s"].number()),
        thread_([this] { watch(); }) {}
  ~StopGuard() {
    stop("connection");
    is_ended_ = true;
    thread_.join();
  }
  // The next request; nothing at the end.
  std::optional<Value> next() {
    std::unique_lock<std::mutex> lock(mutex_);
    arrived_.wait(lock, [this] { return !requests_.empty(); });
    auto request = std::move(requests_.front());
    requests_.pop_front();
    return request;
  }
  // Why the robot stands still; empty while it may move.
  std::string stopped_by() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return stopped_by_;
  }
  void stop(const std::string& reason) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (stopped_by_.empty()) stopped_by_ = reason;
    }
    for (int tries = 0; tries < 1000; ++tries) {
      try {
        return robot_.stop();
      } catch (const std::exception& error) {
        std::cerr << "the stop failed: " << error.what() << '\n';
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
    }
  }
  // After a request that a stop interrupted: its last command may be younger.
  void stop_again() {
    const std::string reason = stopped_by();
    if (!reason.empty()) stop(reason);
  }

 private:
  using Clock = std::chrono::steady_clock;
  void watch() {
    std::vector<std::uint8_t> received;
    auto heard_at = Clock::now();
    std::uint8_t buffer[1 << 16];
    while (!is_ended_) {
      pollfd readable{descriptor_, POLLIN, 0};
      const bool has_data = ::poll(&readable, 1, wait_ms(heard_at)) > 0;
      if (!has_data) {
        if (seconds_since(heard_at) >= watchdog_s_ && stopped_by().empty()) stop("watchdog");
        continue;
      }
      const ssize_t got = ::read(descriptor_, buffer, sizeof buffer);
      if (got <= 0) break;
      heard_at = Clock::now();
      received.insert(received.end(), buffer, buffer + got);
      try {
        take_messages(received);
      } catch (const std::exception& error) {
        std::cerr << "a message cannot be read: " << error.what() << '\n';
        break;
      }
    }
    stop("connection");
    put(std::nullopt);
  }
  int wait_ms(Clock::time_point heard_at) {
    const double look_s = 0.1, left_s = watchdog_s_ - seconds_since(heard_at);
    return int(1000 * (stopped_by().empty() ? std::clamp(left_s, 0.0, look_s) : look_s)) + 1;
  }
  static double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }
  void take_messages(std::vector<std::uint8_t>& received) {
    std::size_t begin = 0;
    while (received.size() - begin >= 4) {
      std::size_t size = 0;
      for (int i = 0; i < 4; ++i) size = size << 8 | received[begin + i];
      if (received.size() - begin - 4 < size) break;
      receive(Reader(received.data() + begin + 4, size).value());
      begin += 4 + size;
    }
    received.erase(received.begin(), received.begin() + std::ptrdiff_t(begin));
  }
  void receive(Value message) {
    const auto* found = std::get_if<std::string>(&message["call"].content);
    const std::string call = found ? *found : "";
    if (call == "stop" || call == "close") stop("server");
    if (call == "reset") {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopped_by_.clear();
    }
    if (call != "stop" && call != "alive") put(std::move(message));
  }
  void put(std::optional<Value> request) {
    const std::lock_guard<std::mutex> lock(mutex_);
    requests_.push_back(std::move(request));
    arrived_.notify_one();
  }
  Robot& robot_;
  const int descriptor_;
  const double watchdog_s_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::deque<std::optional<Value>> requests_;
  std::string stopped_by_ = "start";
  std::atomic<bool> is_ended_{false};
  std::thread thread_;  // the last one: it uses the others
};

class Session {
 public:
  // requests: a descriptor, from which the guard of a robot reads.
  Session(Simulator& simulator, int requests)
      : simulator_(simulator), benchmark_(simulator.benchmark()) {
    if (auto* robot = dynamic_cast<Robot*>(&simulator))
      guard_ = std::make_unique<StopGuard>(*robot, benchmark_, requests);
  }
  // The guard of a robot; null for any other simulator.
  StopGuard* guard() { return guard_.get(); }

  Writer answer(const Value& request) {
    number_ = request["number"];
    const auto* call = std::get_if<std::string>(&request["call"].content);
    try {
      Writer reply;
      if (call == nullptr || !answer_call(*call, request, reply))
        return fault("unknown call", false);
      return reply;
    } catch (const Unplayable& unplayable) {
      return fault(unplayable.what(), true);
    } catch (const std::exception& error) {
      return fault(error.what(), false);
    }
  }

 private:
  bool answer_call(const std::string& call, const Value& request, Writer& reply) {
    if (call == "describe") return describe(request, reply);
    if (call == "reset") return reset(request, reply);
    if (call == "close") return begin(reply, 0), true;
    if (call != "step" && call != "observe" && call != "digest") return false;
    if (!is_reset_) throw std::logic_error(call + " before the first reset");
    if (call == "step") return step(request, reply);
    if (call == "observe") return observe(request, reply);
    const std::string digest = simulator_.digest();
    begin(reply, 1);
    reply.text("digest");
    std::memcpy(reply.room(digest.size()), digest.data(), digest.size());
    return true;
  }
  // The map of a reply, with its first member.
  void begin(Writer& reply, std::size_t members) {
    reply.map(members + 1);
    reply.text("number");
    reply.value(number_);
  }
  bool describe(const Value& request, Writer& reply) {
    for (const auto& protocol : request["protocols"].as<List>())
      if (protocol.number() == kProtocol) {
        begin(reply, 2);
        reply.text("protocol");
        reply.value(kProtocol);
        reply.text("benchmark");
        reply.value(benchmark_);
        return true;
      }
    throw std::runtime_error("this library speaks protocol 1");
  }
  bool reset(const Value& request, Writer& reply) {
    const std::string& task = request["task"].as<std::string>();
    bool is_offered = false;
    for (const auto& name : benchmark_["tasks"].as<List>())
      is_offered = is_offered || name.as<std::string>() == task;
    if (!is_offered) throw Unplayable("there is no task " + task);
    const auto seed = std::uint64_t(request["seed"].number());
    const Beginning begun = simulator_.reset(task, seed, request["split"].as<std::string>());
    is_reset_ = true;
    if (guard_) {
      guard_->stop_again();
      state_ = begun.state;
      if (!guard_->stopped_by().empty())
        throw std::runtime_error("the robot was stopped during its reset");
    }
    begin(reply, 3);
    reply.text("instruction");
    reply.text(begun.instruction);
    reply.text("state");
    reply.numbers(begun.state);
    reply.text("stages");
    reply.value(List(begun.stages.begin(), begun.stages.end()));
    return true;
  }
  bool step(const Value& request, Writer& reply) {
    NumbersByName action;
    for (const auto& [name, numbers] : request["action"].as<Map>())
      for (const auto& value : numbers.as<List>()) action[name].push_back(value.number());
    std::string stopped;
    const StepResult result = guard_ ? step_robot(action, stopped) : simulator_.step(action);
    begin(reply, guard_ ? 6 : 5);
    if (guard_) {
      reply.text("stopped");
      reply.text(stopped);
    }
    reply.text("state");
    reply.numbers(result.state);
    reply.text("success");
    reply.truth(result.success);
    reply.text("terminated");
    reply.truth(result.terminated);
    reply.text("reward");
    reply.number(result.reward);
    reply.text("score");
    reply.number(result.score);
    return true;
  }
  // What a stop interrupts or comes before ends the attempt.
  StepResult step_robot(const NumbersByName& action, std::string& stopped) {
    StepResult result;
    if (guard_->stopped_by().empty()) {
      check_limits(action);
      try {
        result = simulator_.step(action);
        state_ = result.state;
      } catch (const std::exception& error) {
        if (guard_->stopped_by().empty()) {
          guard_->stop("fault");
          throw;
        }
        std::cerr << "a stopped step failed: " << error.what() << '\n';
      }
      guard_->stop_again();
    }
    stopped = guard_->stopped_by();
    result.state = state_;
    result.terminated = result.terminated || !stopped.empty();
    return result;
  }
  // The server has checked them, too, and may have a defect.
  void check_limits(const NumbersByName& action) {
    for (const auto& [name, numbers] : action) {
      const Value& space = benchmark_["action_space"][name];
      const List &low = space["minimum"].as<List>(), &high = space["maximum"].as<List>();
      for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!(low.at(i).number() <= numbers[i] && numbers[i] <= high.at(i).number())) {
          guard_->stop("limits");
          throw std::runtime_error(name + " is beyond its bounds");
        }
    }
  }
  bool observe(const Value& request, Writer& reply) {
    const auto* names = std::get_if<List>(&request["images"].content);
    begin(reply, 1);
    reply.text("images");
    reply.map(names ? names->size() : 0);
    if (!names) return true;
    const int width = int(request["width"].number()), height = int(request["height"].number());
    memory_.follow(request["memory"]);
    for (const auto& camera : *names) {
      const std::string& name = camera.as<std::string>();
      const Value& space = benchmark_["observation_space"]["images"][name];
      const int channels = int(space["channels"].number());
      const std::size_t size = std::size_t(height) * width * channels;
      std::uint8_t* shared = memory_.place(request["memory"]["offsets"][name], size);
      reply.text(name);
      reply.map(shared ? 1 : 2);
      reply.text("shape");
      reply.value(List{height, width, channels});
      if (!shared) reply.text("data");
      simulator_.draw(name, width, height, shared ? shared : reply.room(size));
    }
    return true;
  }
  Writer fault(const std::string& what, bool is_unplayable) {
    Writer reply;
    begin(reply, 2);
    reply.text("fault");
    reply.text(what);
    reply.text("unplayable");
    reply.truth(is_unplayable);
    return reply;
  }
  Simulator& simulator_;
  const Value benchmark_;
  SharedMemory memory_;
  Value number_;
  NumbersByName state_;  // the last one of a robot
  std::unique_ptr<StopGuard> guard_;
  bool is_reset_ = false;
};

// The next request that is read here; nothing at the end.
inline std::optional<Value> read_request(int requests) {
  std::vector<std::uint8_t> received(4);
  if (!read_all(requests, received.data(), 4)) return std::nullopt;
  std::size_t size = 0;
  for (const auto byte : received) size = size << 8 | byte;
  received.resize(size);
  if (!read_all(requests, received.data(), size)) return std::nullopt;
  return Reader(received.data(), size).value();
}

// Answer requests until `close` or their end; whether all replies could be sent.
inline bool answer_all(Simulator& simulator, int requests, int replies) {
  Session session(simulator, requests);
  for (bool is_closed = false; !is_closed;) {
    const auto next = session.guard() ? session.guard()->next() : read_request(requests);
    if (!next) return true;
    const Value& request = *next;
    auto bytes = session.answer(request).bytes;
    const std::size_t length = bytes.size() - 4;
    for (int i = 0; i < 4; ++i) bytes[i] = std::uint8_t(length >> (24 - 8 * i));
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t n = ::write(replies, bytes.data() + sent, bytes.size() - sent);
      if (n <= 0) return false;
      sent += std::size_t(n);
    }
    const auto* call = std::get_if<std::string>(&request["call"].content);
    is_closed = call != nullptr && *call == "close";
  }
  return true;
}

// The next connection. The socket is closed while it is open, so that the server sees
// that the one world is busy.
inline int accept_one(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path)
    throw std::runtime_error("no path of a socket: " + path);
  path.copy(address.sun_path, path.size());
  struct stat status;
  if (::stat(path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode)) ::unlink(path.c_str());
  const int listener = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  int connection = -1;
  if (::bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
      ::listen(listener, 1) == 0)
    connection = ::accept(listener, nullptr, nullptr);
  ::close(listener);
  if (connection < 0) throw std::runtime_error("cannot listen at " + path);
  return connection;
}

// Prints, also of other libraries, must not break a frame, and a crash must not lose them:
// to a pipe, C prints whole blocks, and the last one holds the lines that say why.
inline void print_to_standard_error() {
  ::dup2(2, 1);
  std::fflush(stdout);
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  std::cout << std::unitbuf;
}

}  // namespace detail

// Answer requests until the server closes. Returns the exit code of the program. With an
// address, `unix:PATH`, it listens there and does not return.
inline int serve(Simulator& simulator, const std::string& address = "") {
  if (!address.empty()) {
    if (address.rfind("unix:", 0) != 0) throw std::runtime_error("write unix:PATH");
    std::signal(SIGPIPE, SIG_IGN);  // a server may end its connection at any time
    for (;;) {
      const int connection = detail::accept_one(address.substr(5));
      try {
        detail::answer_all(simulator, connection, connection);
      } catch (const std::exception& error) {
        std::cerr << "the connection failed: " << error.what() << '\n';
      }
      ::close(connection);
    }
  }
  const int requests = ::dup(0), replies = ::dup(1);
  ::dup2(::open("/dev/null", O_RDONLY), 0);
  detail::print_to_standard_error();
  return detail::answer_all(simulator, requests, replies) ? 0 : 1;
}

}  // namespace proctor_simulator

#endif
