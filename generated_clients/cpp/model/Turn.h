/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "Observation.h"
#include "Lease.h"
#include "EpisodeResult.h"
#include "Fault.h"
#include "Timing.h"
#include "EpisodeView.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The answer to attach (turn 0, or in a repeat the latest turn) and to predict.
struct Turn {
    static constexpr char const* schema_name = "Turn";

    std::string session_id{}; // Names the session in every later request.
    std::int64_t seq{}; // Number of the turn.
    std::optional<EpisodeView> episode{};
    std::optional<Observation> observation{};
    std::optional<std::vector<Observation>> observations{}; // With `observe` all, one per executed action.
    std::int32_t executed_steps{}; // How many actions of the chunk were executed.
    bool stopped_early{}; // The episode ended before the chunk did.
    std::vector<double> rewards{}; // One per executed action.
    bool terminated{}; // The task ended by itself in this turn.
    bool truncated{}; // The step limit ended the episode in this turn.
    std::optional<EpisodeResult> episode_result{};
    std::optional<Fault> fault{};
    bool done{}; // No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
    Lease lease{};
    Timing timing{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.required("seq", self.seq);
        visitor.optional("episode", self.episode);
        visitor.optional("observation", self.observation);
        visitor.optional("observations", self.observations);
        visitor.required("executed_steps", self.executed_steps);
        visitor.required("stopped_early", self.stopped_early);
        visitor.required("rewards", self.rewards);
        visitor.required("terminated", self.terminated);
        visitor.required("truncated", self.truncated);
        visitor.optional("episode_result", self.episode_result);
        visitor.optional("fault", self.fault);
        visitor.required("done", self.done);
        visitor.required("lease", self.lease);
        visitor.required("timing", self.timing);
    }
};

} // namespace proctor
