/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "SelectionView.h"
#include "RunPolicy.h"
#include <string>
#include "RunState.h"
#include "PolicyServerView.h"
#include "JudgedRun.h"
#include "Progress.h"
#include <map>
#include <vector>
#include "ImageChoice.h"
#include "../members.h"

namespace proctor {


struct Run {
    static constexpr char const* schema_name = "Run";

    std::string run_id{}; // Names the run in every path.
    RunState state{};
    std::optional<std::string> reason{}; // Why the run is in this state, for people; never null when failed.
    std::optional<bool> retryable{}; // Whether a failed run may be resumed; null in other states.
    std::string benchmark_id{};
    std::string benchmark_version{}; // Version of the benchmark when the run was submitted.
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    RunPolicy policy{};
    std::optional<std::string> mode{}; // A `RunMode`, or one of a later version; `pull` when absent.
    std::optional<PolicyServerView> policy_server{};
    std::optional<bool> any_policy{}; // Whether workers may play for another policy than `policy`; for the profile `attribution`.
    std::optional<SelectionView> select{};
    std::int32_t max_workers{}; // Most live workers that it may have.
    double idle_timeout_s{}; // Lease of its sessions.
    ImageChoice images{};
    std::string endpoint{}; // Base URL of the data plane for this run; the path of an operation is appended to it.
    std::optional<std::int32_t> queue_position{}; // 1 is next; null unless queued.
    std::int32_t live_workers{}; // How many workers have a live session.
    Progress progress{};
    std::string created_at{}; // When it was submitted.
    std::string updated_at{}; // When it changed for the last time; a change that was taken back before it was shown need not count.
    std::optional<std::int32_t> runs_played_before{}; // How many runs of this benchmark its submitter had played before this run was played, deleted ones too; absent before this run is played (DEL-006). For the profile `deletion`.
    std::optional<JudgedRun> judged{};
    std::optional<std::int32_t> attempts_by_submitter{}; // How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("run_id", self.run_id);
        visitor.required("state", self.state);
        visitor.required("reason", self.reason);
        visitor.required("retryable", self.retryable);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("benchmark_version", self.benchmark_version);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("policy", self.policy);
        visitor.optional("mode", self.mode);
        visitor.optional("policy_server", self.policy_server);
        visitor.optional("any_policy", self.any_policy);
        visitor.optional("select", self.select);
        visitor.required("max_workers", self.max_workers);
        visitor.required("idle_timeout_s", self.idle_timeout_s);
        visitor.required("images", self.images);
        visitor.required("endpoint", self.endpoint);
        visitor.required("queue_position", self.queue_position);
        visitor.required("live_workers", self.live_workers);
        visitor.required("progress", self.progress);
        visitor.required("created_at", self.created_at);
        visitor.required("updated_at", self.updated_at);
        visitor.optional("runs_played_before", self.runs_played_before);
        visitor.optional("judged", self.judged);
        visitor.optional("attempts_by_submitter", self.attempts_by_submitter);
    }
};

} // namespace proctor
