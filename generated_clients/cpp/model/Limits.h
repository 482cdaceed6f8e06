/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct Limits {
    static constexpr char const* schema_name = "Limits";

    std::int64_t max_body_bytes{}; // Longest request body that is read, except by `import_record`.
    std::int32_t max_workers{}; // Most live workers a run may ask for.
    std::int32_t max_chunk{}; // Most actions in one predict; a benchmark may allow fewer.
    double idle_timeout_s_min{}; // Shortest lease of a session that a run may have.
    double idle_timeout_s_max{}; // Longest lease of a session that a run may have.
    std::int32_t wait_s_max{}; // Longest wait that a long-poll is granted.
    std::optional<std::int32_t> max_header_bytes{}; // Longest request line with its headers that is read; for the profile `limits`.
    std::optional<double> header_timeout_s{}; // Time in which the headers of a request are complete, from its first byte; for the profile `limits`.
    std::optional<double> body_timeout_s{}; // Time in which a part of a body arrives after the headers of its request; for the profile `limits`.
    std::optional<double> heartbeat_s_max{}; // Longest time that a session lives without a new turn, or its `idle_timeout_s` if that is longer; for the profile `limits`.
    std::optional<double> unused_s_max{}; // When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`.
    std::optional<std::int64_t> max_control_body_bytes{}; // Longest body that is read of a request other than `predict` and `import_record`, where it is less than `max_body_bytes`; for the profile `limits`.
    std::optional<std::int32_t> max_open_runs{}; // Most runs of one account that are queued, ready, running or stopping; for the profile `limits`.
    std::optional<std::int64_t> max_idempotency_keys{}; // Most Idempotency-Keys that one account may use; for the profile `limits`.
    std::optional<std::int64_t> max_stored_bytes{}; // Most bytes that one account may have stored, see [LIM-010](profiles/limits.md). For the profile `limits`.
    std::optional<std::int64_t> max_record_bytes{}; // Longest archive that `import_record` reads; for the profile `record_import`.
    std::optional<std::int32_t> max_waiting_imports{}; // Most imports of one account that are not `finished`; for the profile `record_import`.
    std::optional<std::int64_t> max_imported_bytes{}; // Most bytes that the archives of one account may have together; for the profile `record_import`.
    std::optional<double> run_keep_days{}; // Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("max_body_bytes", self.max_body_bytes);
        visitor.required("max_workers", self.max_workers);
        visitor.required("max_chunk", self.max_chunk);
        visitor.required("idle_timeout_s_min", self.idle_timeout_s_min);
        visitor.required("idle_timeout_s_max", self.idle_timeout_s_max);
        visitor.required("wait_s_max", self.wait_s_max);
        visitor.optional("max_header_bytes", self.max_header_bytes);
        visitor.optional("header_timeout_s", self.header_timeout_s);
        visitor.optional("body_timeout_s", self.body_timeout_s);
        visitor.optional("heartbeat_s_max", self.heartbeat_s_max);
        visitor.optional("unused_s_max", self.unused_s_max);
        visitor.optional("max_control_body_bytes", self.max_control_body_bytes);
        visitor.optional("max_open_runs", self.max_open_runs);
        visitor.optional("max_idempotency_keys", self.max_idempotency_keys);
        visitor.optional("max_stored_bytes", self.max_stored_bytes);
        visitor.optional("max_record_bytes", self.max_record_bytes);
        visitor.optional("max_waiting_imports", self.max_waiting_imports);
        visitor.optional("max_imported_bytes", self.max_imported_bytes);
        visitor.optional("run_keep_days", self.run_keep_days);
    }
};

} // namespace proctor
