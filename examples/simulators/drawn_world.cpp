// A world in C++: a point is pushed to a target, and two cameras draw it.
//
// Copy proctor_simulator.hpp beside this file; then
//
//     g++ -O2 -std=c++17 drawn_world.cpp -o drawn_world
//     proctor-server --simulator ./drawn_world

#include "proctor_simulator.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace ps = proctor_simulator;

constexpr double kNear = 0.05, kStep = 0.05;  // metres

class PointWorld : public ps::Simulator {
 public:
  ps::Value benchmark() override {
    return ps::Map{
        {"benchmark_id", "drawn_world"},
        {"title", "A point in the plane"},
        {"simulator", ps::Map{{"name", "drawn_world"}, {"version", "1"}}},
        {"tasks", ps::List{"reach", "return"}},
        {"max_steps", 60},
        {"control_rate_hz", 10.0},
        {"digest", true},
        {"shared_memory", true},
        {"action_space", ps::Map{{"velocity", ps::numbers(2, {-1, -1}, {1, 1})}}},
        {"observation_space",
         ps::Map{{"state", ps::Map{{"position", in_plane()},
                                   {"target", in_plane()}}},
                 {"images", ps::Map{{"top", camera("from above")}, {"near", camera("zoomed")}}},
                 {"tensors", ps::Map{}}}},
        {"image_sizes", ps::List{ps::Map{{"width", 64}, {"height", 64}},
                                 ps::Map{{"width", 640}, {"height", 480}}}}};
  }

  ps::Beginning reset(const std::string& task, std::uint64_t seed, const std::string&) override {
    std::mt19937_64 random(seed);  // the same numbers with every compiler
    const auto draw = [&random] { return double(random() >> 11) / (1ull << 52) - 1.0; };
    position_ = {draw(), draw()};
    target_ = {draw(), draw()};
    if (task == "return") target_ = {0, 0};
    return {task == "reach" ? "Reach the red target." : "Return to the centre.", state()};
  }

  ps::StepResult step(const ps::NumbersByName& action) override {
    const ps::Numbers& velocity = action.at("velocity");
    for (int i = 0; i < 2; ++i)
      position_[i] = std::clamp(position_[i] + kStep * velocity.at(i), -1.0, 1.0);
    const double dx = position_[0] - target_[0], dy = position_[1] - target_[1];
    const double distance = std::sqrt(dx * dx + dy * dy);
    return {state(), distance < kNear, distance < kNear, -distance};
  }

  void draw(const std::string& camera, int width, int height, std::uint8_t* pixels) override {
    std::fill(pixels, pixels + std::size_t(width) * height * 3, 240);
    const double zoom = camera == "near" ? 2.0 : 1.0;
    disc(pixels, width, height, target_, zoom, {200, 30, 30});
    disc(pixels, width, height, position_, zoom, {30, 30, 200});
  }

  std::string digest() override {
    std::string bytes;
    for (const ps::Numbers& numbers : {position_, target_})
      bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    return bytes;
  }

 private:
  static ps::Map in_plane() {
    return ps::vector({{"xy", ps::part(2, "position", "m", "world")}});
  }
  static ps::Map camera(const char* text) {
    return {{"channels", 3}, {"description", text}};
  }
  ps::NumbersByName state() const { return {{"position", position_}, {"target", target_}}; }

  static void disc(std::uint8_t* pixels, int width, int height, const ps::Numbers& centre,
                   double zoom, const std::vector<int>& colour) {
    const int radius = std::max(2, width / 32);
    const int x = int(std::lround((centre[0] * zoom + 1) / 2 * (width - 1)));
    const int y = int(std::lround((1 - centre[1] * zoom) / 2 * (height - 1)));
    for (int row = std::max(0, y - radius); row <= std::min(height - 1, y + radius); ++row)
      for (int column = std::max(0, x - radius); column <= std::min(width - 1, x + radius); ++column)
        if ((row - y) * (row - y) + (column - x) * (column - x) <= radius * radius)
          for (int i = 0; i < 3; ++i)
            pixels[(std::size_t(row) * width + column) * 3 + i] = std::uint8_t(colour[i]);
  }

  ps::Numbers position_{0, 0}, target_{0, 0};
};

int main(int count, char** words) {
  PointWorld world;
  return ps::serve(world, count > 1 ? words[1] : "");
}
