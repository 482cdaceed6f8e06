/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "Limits.h"
#include "ProtocolRange.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// What a server says of itself before anyone authenticates.
struct Service {
    static constexpr char const* schema_name = "Service";

    std::string name{}; // Name of the server software.
    std::string version{}; // Version of the server software.
    ProtocolRange protocol{};
    std::vector<std::string> profiles{}; // Parts of the protocol offered, which [levels](levels.md) explains; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart a server of the level Service; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these.
    Limits limits{};
    std::vector<std::string> encodings{}; // Media types of the data plane.
    std::vector<std::string> image_codecs{};
    std::string server_time{}; // The server's clock, UTC.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.required("version", self.version);
        visitor.required("protocol", self.protocol);
        visitor.required("profiles", self.profiles);
        visitor.required("limits", self.limits);
        visitor.required("encodings", self.encodings);
        visitor.required("image_codecs", self.image_codecs);
        visitor.required("server_time", self.server_time);
    }
};

} // namespace proctor
