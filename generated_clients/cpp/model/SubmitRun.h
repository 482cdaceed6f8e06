/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "PolicyServer.h"
#include "CalibrationOptions.h"
#include "RunMode.h"
#include <string>
#include "EpisodeSelection.h"
#include "PolicyInfo.h"
#include <vector>
#include "ImageChoice.h"
#include "../members.h"

namespace proctor {


struct SubmitRun {
    static constexpr char const* schema_name = "SubmitRun";

    std::string benchmark_id{}; // One of `list_benchmarks`.
    PolicyInfo policy{};
    std::optional<std::int32_t> max_workers{}; // Most live workers wanted; the server's limit when absent.
    std::optional<double> idle_timeout_s{}; // Lease of a session; the server's maximum when absent. For the profile `sessions`.
    std::optional<ImageChoice> images{};
    std::optional<CalibrationOptions> options{};
    std::optional<RunMode> mode{};
    std::optional<PolicyServer> policy_server{};
    std::optional<bool> any_policy{}; // Workers may play for another policy than `policy`; false when absent; for the profile `attribution`.
    std::optional<EpisodeSelection> select{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("policy", self.policy);
        visitor.optional("max_workers", self.max_workers);
        visitor.optional("idle_timeout_s", self.idle_timeout_s);
        visitor.optional("images", self.images);
        visitor.optional("options", self.options);
        visitor.optional("mode", self.mode);
        visitor.optional("policy_server", self.policy_server);
        visitor.optional("any_policy", self.any_policy);
        visitor.optional("select", self.select);
    }
};

} // namespace proctor
