/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "PolicyProtocol.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// Where the server finds the policy of a run with mode `push`, and how it calls it.
struct PolicyServer {
    static constexpr char const* schema_name = "PolicyServer";

    std::string url{}; // Base URL, without user, query or fragment; the path of an operation is appended to it.
    PolicyProtocol protocol{};
    std::optional<std::string> api_key{}; // Sent as bearer token with every call, and never shown.
    std::optional<std::string> model{}; // Which model is asked, where a protocol knows several.
    std::optional<double> call_timeout_s{}; // Time for one call, from connecting to the last byte of its answer; 30 when absent.
    std::optional<std::int32_t> max_concurrent{}; // Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
    std::optional<std::int32_t> max_retries{}; // How often a call that was not answered is repeated; 3 when absent.
    std::optional<std::map<std::string, double>> generation{}; // Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("url", self.url);
        visitor.required("protocol", self.protocol);
        visitor.optional("api_key", self.api_key);
        visitor.optional("model", self.model);
        visitor.optional("call_timeout_s", self.call_timeout_s);
        visitor.optional("max_concurrent", self.max_concurrent);
        visitor.optional("max_retries", self.max_retries);
        visitor.optional("generation", self.generation);
    }
};

} // namespace proctor
