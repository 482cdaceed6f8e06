/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct PublicKey {
    static constexpr char const* schema_name = "PublicKey";

    std::string keyid{}; // `SHA256:` and the SHA-256 of the key in hexadecimal digits.
    std::string algorithm{}; // `ed25519`, or another one of a later version.
    std::string public_key{}; // Its 32 bytes.
    std::string created_at{};
    std::optional<std::string> retired_at{}; // When it signed for the last time; null for the key in use.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("keyid", self.keyid);
        visitor.required("algorithm", self.algorithm);
        visitor.required("public_key", self.public_key);
        visitor.required("created_at", self.created_at);
        visitor.required("retired_at", self.retired_at);
    }
};

} // namespace proctor
