/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// Server time of this turn, in seconds.
struct Timing {
    static constexpr char const* schema_name = "Timing";

    double total_s{}; // The whole turn on the server.
    double queue_s{}; // Waiting for the simulator.
    double simulate_s{}; // Executing actions.
    double render_s{}; // Rendering images.
    double encode_s{}; // Encoding of images.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("total_s", self.total_s);
        visitor.required("queue_s", self.queue_s);
        visitor.required("simulate_s", self.simulate_s);
        visitor.required("render_s", self.render_s);
        visitor.required("encode_s", self.encode_s);
    }
};

} // namespace proctor
