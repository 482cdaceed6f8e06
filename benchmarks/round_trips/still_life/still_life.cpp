// The still picture of world.py as a program that speaks the simulator protocol.
//
//     still_life state|cameras

#include "proctor_simulator.hpp"

#include <cmath>

namespace ps = proctor_simulator;

constexpr int kJoints = 12, kGrippers = 4, kBase = 7, kHeight = 480, kWidth = 640;
const std::vector<std::string> kCameras = {"head", "front", "left_wrist", "right_wrist"};

class StillLife : public ps::Simulator {
 public:
  explicit StillLife(bool has_cameras) : has_cameras_(has_cameras) {
    for (std::size_t number = 0; number < kCameras.size(); ++number) {
      picture_[number].resize(std::size_t(kHeight) * kWidth * 3);
      for (std::size_t i = 0; i < picture_[number].size(); ++i)
        picture_[number][i] = std::uint8_t(i * 7 / 640 + number);
    }
  }

  ps::Value benchmark() override {
    ps::Map images, state{{"joint_position", ps::numbers(kJoints)},
                          {"gripper", ps::numbers(kGrippers)},
                          {"base", ps::numbers(kBase)}};
    for (std::size_t i = 0; has_cameras_ && i < kCameras.size(); ++i)
      images.push_back({kCameras[i], ps::Map{{"channels", 3}, {"description", "A table."}}});
    const ps::Numbers low(kJoints, -1), high(kJoints, 1), low_4(4, -1), high_4(4, 1);
    return ps::Map{
        {"benchmark_id", has_cameras_ ? "external_cameras" : "external_state"},
        {"simulator", ps::Map{{"name", "still_life"}, {"version", "1"}}},
        {"tasks", ps::List{"sit"}},
        {"max_steps", 200},
        {"digest", true},
        {"shared_memory", true},
        {"splits", ps::List{ps::Map{{"name", "test"}, {"episodes", 2000}, {"first_seed", 1}}}},
        {"action_space", ps::Map{{"joint_position", ps::numbers(kJoints, low, high)},
                                 {"gripper", ps::numbers(4, low_4, high_4)}}},
        {"observation_space", ps::Map{{"state", state}, {"images", images}}},
        {"image_sizes", ps::List{ps::Map{{"width", kWidth}, {"height", kHeight}}}}};
  }

  ps::Beginning reset(const std::string&, std::uint64_t seed, const std::string&) override {
    step_ = 1000 * double(seed);
    echo_ = -2;
    drawn_.clear();
    return {"Sit for a portrait.", state()};
  }

  ps::StepResult step(const ps::NumbersByName& action) override {
    step_ += 1;
    echo_ = action.at("joint_position")[0];
    return {state()};
  }

  void draw(const std::string& camera, int, int, std::uint8_t* pixels) override {
    std::size_t number = 0;
    while (kCameras[number] != camera) ++number;
    // Like world.py: what lies in shared memory already is not drawn again.
    if (drawn_[pixels] != number + 1)
      std::memcpy(pixels, picture_[number].data(), picture_[number].size());
    drawn_[pixels] = number + 1;
    std::memset(pixels, int(std::fmod(step_, 251)), 3);
  }

  std::string digest() override {
    return {reinterpret_cast<const char*>(&step_), sizeof step_};
  }

 private:
  ps::NumbersByName state() const {
    ps::Numbers values(kJoints + kGrippers + kBase);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = std::sin(6.0 * double(i) / double(values.size() - 1) + 0.1 * step_);
    values[kJoints + kGrippers] = step_;
    values[kJoints + kGrippers + 1] = echo_;
    const auto begin = values.begin();
    return {{"joint_position", {begin, begin + kJoints}},
            {"gripper", {begin + kJoints, begin + kJoints + kGrippers}},
            {"base", {begin + kJoints + kGrippers, values.end()}}};
  }

  bool has_cameras_;
  double step_ = 0, echo_ = -2;
  std::vector<std::uint8_t> picture_[4];
  std::map<const std::uint8_t*, std::size_t> drawn_;
};

int main(int argc, char** argv) {
  StillLife world(argc > 1 && std::string(argv[1]) == "cameras");
  return ps::serve(world);
}
