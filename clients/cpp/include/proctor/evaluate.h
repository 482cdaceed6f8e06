/* Evaluate a robot policy on any Proctor server:
 *
 *     auto policy = [](proctor::PolicyInput const& seen) { return std::vector<proctor::Action>{...}; };
 *     proctor::Score score = proctor::evaluate({url, token}, "tabletop", policy);
 */
#pragma once

#include <cstring>

#include "proctor/session.h"

namespace proctor {

/// An image, row 0 on top. `raw`: height × width × channels bytes; else a file of this codec.
struct DecodedImage {
    std::string codec;
    std::int32_t height, width, channels;
    std::vector<std::uint8_t> data;
};

/// An array in C order, little-endian; a bool is one byte.
struct DecodedTensor {
    std::string dtype;
    std::vector<std::int64_t> shape;
    std::vector<std::uint8_t> bytes;

    /// The numbers, as the C++ type of `dtype`.
    template <typename Number> std::vector<Number> as() const {
        std::vector<Number> numbers(bytes.size() / sizeof(Number));
        if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
        return numbers;
    }
};

/// What a policy receives, in the units and frames of the benchmark's spaces.
struct PolicyInput {
    std::map<std::string, std::vector<double>> state;
    std::map<std::string, DecodedImage> images;
    std::map<std::string, DecodedTensor> tensors;
    std::string instruction; ///< The task of this episode, in natural language.
    std::string task, episode_id;
    std::int32_t step;    ///< Actions executed in this attempt; 0 in an episode's first input.
    Turn const* turn;     ///< The whole message; valid during the call.
};

/// The parts of an observation that need decoding; throws Error `bad_answer`.
PolicyInput decode(Observation const& seen);

/// Plays episodes one after another; every worker has its own, in its own thread.
struct Policy {
    virtual ~Policy() = default;
    /// An episode begins or restarts: discard all earlier state.
    virtual void reset(std::string const& /*instruction*/) {}
    /// The next actions: 1 to the benchmark's `max_chunk`.
    virtual std::vector<Action> act(PolicyInput const& input) = 0;
};

using MakePolicy = std::function<std::unique_ptr<Policy>()>;
/// A policy without state. With several workers, several threads call it at a time.
using Act = std::function<std::vector<Action>(PolicyInput const&)>;

struct EvaluateOptions {
    /// Of a new run: images, lease, tasks, name of the policy. benchmark_id is filled in.
    SubmitRun submission{};
    int workers = 1;                       ///< Episodes played at a time.
    std::string worker_prefix = "worker";  ///< Must differ between programs that share a run.
    bool takeover = false;                 ///< Take over the sessions of a crashed program.
    std::optional<Assumptions> assumes{};  ///< Conventions that the policy assumes.
    std::function<void(Run const&)> on_run{}; ///< As soon as the run exists.
    /// Each result that a worker of this program has played; one call at a time.
    std::function<void(EpisodeResult const&, std::string const& worker_id)> on_result{};
};

/// The score of a new run. Throws Error (RunFailed and RunStopped when the run ends without a
/// score), Interrupted, and what the policy throws. The run remains: resume_evaluation continues it.
Score evaluate(Server const& server, std::string const& benchmark_id, MakePolicy const& make_policy, EvaluateOptions options = {});
Score evaluate(Server const& server, std::string const& benchmark_id, Act const& act, EvaluateOptions options = {});

/// Continue a run, which is resumed if it is stopped or failed. Else as `evaluate`.
Score resume_evaluation(Server const& server, std::string const& run_id, MakePolicy const& make_policy, EvaluateOptions options = {});
Score resume_evaluation(Server const& server, std::string const& run_id, Act const& act, EvaluateOptions options = {});

} // namespace proctor
