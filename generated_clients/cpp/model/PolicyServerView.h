/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The policy server of a run with mode `push`, with what was left open filled in, and without its key.
struct PolicyServerView {
    static constexpr char const* schema_name = "PolicyServerView";

    std::string url{};
    std::string protocol{}; // A `PolicyProtocol`, or one of a later version.
    bool has_api_key{};
    std::optional<std::string> model{};
    double call_timeout_s{};
    std::int32_t max_concurrent{};
    std::int32_t max_retries{};
    std::optional<std::map<std::string, double>> generation{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("url", self.url);
        visitor.required("protocol", self.protocol);
        visitor.required("has_api_key", self.has_api_key);
        visitor.optional("model", self.model);
        visitor.required("call_timeout_s", self.call_timeout_s);
        visitor.required("max_concurrent", self.max_concurrent);
        visitor.required("max_retries", self.max_retries);
        visitor.optional("generation", self.generation);
    }
};

} // namespace proctor
