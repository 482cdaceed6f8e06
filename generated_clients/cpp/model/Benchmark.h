/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "VectorSpace.h"
#include "ImageSize.h"
#include "SimulatorInfo.h"
#include <string>
#include "ObservationSpace.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// Everything about a benchmark that can change a score.
struct Benchmark {
    static constexpr char const* schema_name = "Benchmark";

    std::string benchmark_id{};
    std::string version{};
    std::string title{};
    std::string description{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::int32_t episodes_total{};
    std::vector<std::string> tasks{};
    std::optional<std::map<std::string, std::string>> task_goals{}; // Task → when its goal holds, in a sentence for people; absent where nothing is said.
    std::vector<std::string> splits{};
    std::optional<std::vector<std::string>> sealed_splits{}; // Splits whose seeds the host draws in secret; none when absent.
    std::optional<std::string> seeds_sha256{}; // What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played.
    double control_rate_hz{}; // Actions per simulated second.
    std::int32_t max_steps{}; // Steps after which an episode is truncated.
    std::int32_t max_chunk{};
    std::int32_t max_attempts{};
    std::int32_t max_faults{};
    std::string success_rule{}; // A `SuccessRule`, or one of a later version.
    std::map<std::string, VectorSpace> action_space{}; // Name of an action value → what it means.
    ObservationSpace observation_space{};
    std::vector<ImageSize> image_sizes{}; // Sizes that may be chosen at submit; the first is the default.
    std::vector<std::string> image_codecs{}; // Codecs that may be chosen at submit; the first is the default.
    SimulatorInfo simulator{};
    std::optional<std::string> unavailable_reason{}; // Why a run cannot be submitted here now, and the cure; null when it can.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("version", self.version);
        visitor.required("title", self.title);
        visitor.required("description", self.description);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("episodes_total", self.episodes_total);
        visitor.required("tasks", self.tasks);
        visitor.optional("task_goals", self.task_goals);
        visitor.required("splits", self.splits);
        visitor.optional("sealed_splits", self.sealed_splits);
        visitor.optional("seeds_sha256", self.seeds_sha256);
        visitor.required("control_rate_hz", self.control_rate_hz);
        visitor.required("max_steps", self.max_steps);
        visitor.required("max_chunk", self.max_chunk);
        visitor.required("max_attempts", self.max_attempts);
        visitor.required("max_faults", self.max_faults);
        visitor.required("success_rule", self.success_rule);
        visitor.required("action_space", self.action_space);
        visitor.required("observation_space", self.observation_space);
        visitor.required("image_sizes", self.image_sizes);
        visitor.required("image_codecs", self.image_codecs);
        visitor.required("simulator", self.simulator);
        visitor.required("unavailable_reason", self.unavailable_reason);
    }
};

} // namespace proctor
