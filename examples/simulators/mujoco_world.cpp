// A world of MuJoCo in C++: a puck is pushed to a target, and a camera of MuJoCo draws it.
//
// Copy proctor_simulator.hpp beside this file. MuJoCo's headers and library are those of
// the Python package, or of a release of MuJoCo; pictures need EGL, and no screen.
//
//     M=$(python -c "import mujoco; print(mujoco.__path__[0])")
//     g++ -O2 -std=c++17 -I$M/include mujoco_world.cpp $M/libmujoco.so.* -lEGL
//         -Wl,-rpath,$M -o mujoco_world   (one line)
//     proctor-server --simulator ./mujoco_world

#include "proctor_simulator.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ps = proctor_simulator;

constexpr int kSubsteps = 20;
constexpr double kNear = 0.05;  // metres
constexpr const char* kModel = R"(
<mujoco>
  <option timestep="0.005"/>
  <visual>
    <global offwidth="640" offheight="640"/>
    <headlight ambient=".3 .3 .3" diffuse=".1 .1 .1" specular="0 0 0"/>
  </visual>
  <worldbody>
    <light pos="0 0 3" diffuse=".4 .4 .4"/>
    <camera name="top" pos="0 0 3" fovy="45"/>
    <geom type="plane" size="1.2 1.2 .1" rgba=".9 .9 .9 1"/>
    <body name="target" mocap="true" pos=".5 .5 .01">
      <geom type="cylinder" size=".06 .005" rgba=".8 .1 .1 1" contype="0" conaffinity="0"/>
    </body>
    <body pos="0 0 .05">
      <joint name="x" type="slide" axis="1 0 0" range="-1 1" limited="true" damping="2"/>
      <joint name="y" type="slide" axis="0 1 0" range="-1 1" limited="true" damping="2"/>
      <geom type="cylinder" size=".05 .02" rgba=".1 .1 .8 1" mass="1"/>
    </body>
  </worldbody>
  <actuator>
    <velocity joint="x" kv="20" ctrlrange="-1 1" ctrllimited="true"/>
    <velocity joint="y" kv="20" ctrlrange="-1 1" ctrllimited="true"/>
  </actuator>
</mujoco>)";

class PuckWorld : public ps::Simulator {
 public:
  PuckWorld() {
    mjVFS files;
    mj_defaultVFS(&files);
    mj_addBufferVFS(&files, "model.xml", kModel, int(std::strlen(kModel)));
    char error[500];
    model_ = mj_loadXML("model.xml", &files, error, sizeof error);
    mj_deleteVFS(&files);
    if (!model_) throw std::runtime_error(error);
    data_ = mj_makeData(model_);
  }

  ps::Value benchmark() override {
    return ps::Map{
        {"benchmark_id", "mujoco_world"},
        {"title", "A puck on a table"},
        {"simulator", ps::Map{{"name", "mujoco_world"},
                              {"version", "1"},
                              {"mujoco", mj_versionString()}}},
        {"tasks", ps::List{"reach"}},
        {"max_steps", 100},
        {"control_rate_hz", 10.0},
        {"digest", true},
        {"shared_memory", true},
        {"action_space", ps::Map{{"velocity", ps::vector({{"xy", ps::part(2, "linear_velocity", "m/s", "world")}}, {-1, -1}, {1, 1})}}},
        {"observation_space",
         ps::Map{{"state", ps::Map{{"position", in_plane()},
                                   {"target", in_plane()}}},
                 {"images", ps::Map{{"top", ps::Map{{"channels", 3},
                                                    {"description", "from above"}}}}}}},
        {"image_sizes", ps::List{ps::Map{{"width", 128}, {"height", 128}},
                                 ps::Map{{"width", 640}, {"height", 480}}}}};
  }

  ps::Beginning reset(const std::string&, std::uint64_t seed, const std::string&) override {
    std::mt19937_64 random(seed);
    const auto draw = [&random] { return 1.6 * double(random() >> 11) / (1ull << 53) - 0.8; };
    mj_resetData(model_, data_);
    for (int i = 0; i < 2; ++i) data_->qpos[i] = draw(), data_->mocap_pos[i] = draw();
    mj_forward(model_, data_);
    return {"Push the blue puck onto the red target.", state()};
  }

  ps::StepResult step(const ps::NumbersByName& action) override {
    for (int i = 0; i < 2; ++i) data_->ctrl[i] = action.at("velocity").at(i);
    for (int i = 0; i < kSubsteps; ++i) mj_step(model_, data_);
    mj_forward(model_, data_);
    const double distance = std::hypot(data_->qpos[0] - data_->mocap_pos[0],
                                       data_->qpos[1] - data_->mocap_pos[1]);
    return {state(), distance < kNear, distance < kNear, -distance};
  }

  void draw(const std::string& name, int width, int height, std::uint8_t* pixels) override {
    open_renderer();
    const mjrRect view{0, 0, width, height};
    camera_.type = mjCAMERA_FIXED;
    camera_.fixedcamid = mj_name2id(model_, mjOBJ_CAMERA, name.c_str());
    mjv_updateScene(model_, data_, &options_, nullptr, &camera_, mjCAT_ALL, &scene_);
    mjr_render(view, &scene_, &context_);
    mjr_readPixels(pixels, nullptr, view, &context_);
    // OpenGL has the bottom row first.
    for (int row = 0; row < height / 2; ++row)
      std::swap_ranges(pixels + row * width * 3, pixels + (row + 1) * width * 3,
                       pixels + (height - 1 - row) * width * 3);
  }

  std::string digest() override {
    const int size = mj_stateSize(model_, mjSTATE_INTEGRATION);
    std::vector<mjtNum> numbers(size);
    mj_getState(model_, data_, numbers.data(), mjSTATE_INTEGRATION);
    return {reinterpret_cast<const char*>(numbers.data()), size * sizeof(mjtNum)};
  }

 private:
  static ps::Map in_plane() {
    return ps::vector({{"xy", ps::part(2, "position", "m", "world")}});
  }
  ps::NumbersByName state() const {
    return {{"position", {data_->qpos[0], data_->qpos[1]}},
            {"target", {data_->mocap_pos[0], data_->mocap_pos[1]}}};
  }

  void open_renderer() {
    if (is_open_) return;
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_DEPTH_SIZE, 24, EGL_NONE};
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLConfig config;
    EGLint found = 0;
    if (!eglInitialize(display, nullptr, nullptr) ||
        !eglChooseConfig(display, wanted, &config, 1, &found) || found == 0 ||
        !eglBindAPI(EGL_OPENGL_API))
      throw std::runtime_error("EGL cannot draw here");
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
      throw std::runtime_error("EGL has no context");
    mjv_defaultOption(&options_);
    mjv_defaultCamera(&camera_);
    mjv_defaultScene(&scene_);
    mjr_defaultContext(&context_);
    mjv_makeScene(model_, &scene_, 100);
    mjr_makeContext(model_, &context_, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context_);
    is_open_ = true;
  }

  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
  mjvOption options_;
  mjvCamera camera_;
  mjvScene scene_;
  mjrContext context_;
  bool is_open_ = false;
};

int main(int count, char** words) {
  PuckWorld world;
  return ps::serve(world, count > 1 ? words[1] : "");
}
