/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "EpisodeResult.h"
#include "EpisodeStatus.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct Episode {
    static constexpr char const* schema_name = "Episode";

    std::string episode_id{};
    std::int32_t index{}; // Position in the manifest.
    std::string task{};
    std::string split{};
    EpisodeStatus status{};
    std::int32_t attempt{}; // The current or next attempt.
    std::int32_t faults{}; // How often the simulator broke, or a trial was void (FAULT-009).
    std::optional<std::string> policy_fault{}; // In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode.
    std::optional<EpisodeResult> result{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("index", self.index);
        visitor.required("task", self.task);
        visitor.required("split", self.split);
        visitor.required("status", self.status);
        visitor.required("attempt", self.attempt);
        visitor.required("faults", self.faults);
        visitor.optional("policy_fault", self.policy_fault);
        visitor.optional("result", self.result);
    }
};

} // namespace proctor
