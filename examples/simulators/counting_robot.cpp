// A robot without a body in C++: it counts, and stops. Copy proctor_simulator.hpp beside it.
//
//     g++ -std=c++17 -O2 -pthread counting_robot.cpp -o counting_robot
//     proctor-server --simulator ./counting_robot

#include "proctor_simulator.hpp"

#include <atomic>

using namespace proctor_simulator;

class CountingRobot : public Robot {
 public:
  Value benchmark() override {
    return Map{
        {"benchmark_id", "counting_robot"},
        {"simulator", Map{{"name", "counting_robot"}, {"version", "1"}}},
        {"tasks", List{"count"}},
        {"max_steps", 20},
        {"deterministic", false},
        {"action_space", Map{{"add", numbers(1, {0.0}, {0.1})}}},
        {"observation_space", Map{{"state", Map{{"sum", numbers(1)}}}}},
        {"physical",
         Map{{"stop_within_s", 0.1},
             {"watchdog_s", 1.0},
             {"setups", Map{{"count", Map{{"instruction", "Take your hands away."}}}}},
             {"rubric", Map{{"success", "It has counted."}}}}}};
  }
  Beginning reset(const std::string&, std::uint64_t, const std::string&) override {
    sum_ = 0.0;
    may_move_ = true;
    return {"Please count.", {{"sum", {sum_}}}};
  }
  StepResult step(const NumbersByName& action) override {
    if (may_move_) sum_ += action.at("add").at(0);
    return {{{"sum", {sum_}}}};
  }
  void stop() override { may_move_ = false; }

 private:
  double sum_ = 0.0;
  std::atomic<bool> may_move_{false};
};

int main(int argc, char** argv) {
  CountingRobot robot;
  return serve(robot, argc > 1 ? argv[1] : "");
}
