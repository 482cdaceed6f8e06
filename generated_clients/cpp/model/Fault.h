/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one.
struct Fault {
    static constexpr char const* schema_name = "Fault";

    std::string episode_id{}; // Which episode began again.
    std::int32_t faults{}; // Faults of this episode so far.
    std::string detail{}; // What happened, for people.
    std::optional<bool> is_void{}; // True where no simulator broke: a person said that the trial does not count; with the profile `physical`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("faults", self.faults);
        visitor.required("detail", self.detail);
        visitor.optional("is_void", self.is_void);
    }
};

} // namespace proctor
