/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "RunState.h"
#include <map>
#include <vector>
#include "SideEffects.h"
#include "ProblemItem.h"
#include "../members.h"

namespace proctor {

/// RFC 9457, with what a client needs to decide on a retry.
struct Problem {
    static constexpr char const* schema_name = "Problem";

    std::string type{}; // `urn:proctor:problem:` and the code.
    std::string title{}; // What the code means.
    std::int32_t status{}; // Status of the response.
    std::string detail{}; // What happened and what to do about it.
    std::string code{}; // One of x-problems, or one of a later version.
    bool retryable{}; // Whether the same request can succeed later.
    SideEffects side_effects{};
    std::optional<std::vector<ProblemItem>> errors{};
    std::optional<std::string> requirement{}; // Id of the rule that was enforced.
    std::optional<RunState> state{};
    std::optional<std::int64_t> expected_seq{}; // Of `seq_out_of_order`: the next seq.
    std::optional<std::string> ended_by{}; // What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
    std::optional<std::string> entry_id{}; // Of `result_published`: the entry of that result.
    std::optional<std::string> limit{}; // Of `quota_exceeded`: the limit that was reached, where the server names it.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("type", self.type);
        visitor.required("title", self.title);
        visitor.required("status", self.status);
        visitor.required("detail", self.detail);
        visitor.required("code", self.code);
        visitor.required("retryable", self.retryable);
        visitor.required("side_effects", self.side_effects);
        visitor.optional("errors", self.errors);
        visitor.optional("requirement", self.requirement);
        visitor.optional("state", self.state);
        visitor.optional("expected_seq", self.expected_seq);
        visitor.optional("ended_by", self.ended_by);
        visitor.optional("entry_id", self.entry_id);
        visitor.optional("limit", self.limit);
    }
};

} // namespace proctor
