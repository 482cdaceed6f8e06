/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "PlayerView.h"
#include <string>
#include "Outcome.h"
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct EpisodeResult {
    static constexpr char const* schema_name = "EpisodeResult";

    std::string episode_id{};
    std::int32_t index{}; // Position in the manifest.
    std::string task{};
    std::string split{};
    std::optional<std::int64_t> seed{}; // Absent where `sealed_splits` of the manifest of the run names the split.
    std::int32_t attempt{}; // The attempt that was scored.
    std::int32_t faults{}; // How often the simulator broke, or a trial was void (FAULT-009).
    Outcome outcome{};
    double score{}; // From 0 to 1.
    std::int32_t steps{}; // Actions executed in the attempt.
    bool terminated{}; // The task ended by itself.
    bool truncated{}; // The step limit ended the episode.
    double think_s{}; // Time between turns that the policy took.
    std::string finished_at{};
    std::optional<PlayerView> player{};
    std::optional<std::int32_t> clipped_actions{}; // Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`.
    std::optional<double> total_reward{}; // Sum of the rewards of the attempt, its return; for the profile `attribution`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("index", self.index);
        visitor.required("task", self.task);
        visitor.required("split", self.split);
        visitor.optional("seed", self.seed);
        visitor.required("attempt", self.attempt);
        visitor.required("faults", self.faults);
        visitor.required("outcome", self.outcome);
        visitor.required("score", self.score);
        visitor.required("steps", self.steps);
        visitor.required("terminated", self.terminated);
        visitor.required("truncated", self.truncated);
        visitor.required("think_s", self.think_s);
        visitor.required("finished_at", self.finished_at);
        visitor.optional("player", self.player);
        visitor.optional("clipped_actions", self.clipped_actions);
        visitor.optional("total_reward", self.total_reward);
    }
};

} // namespace proctor
