/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <vector>
#include "../members.h"

namespace proctor {

/// What an entry says of itself; a member that is absent is not shown.
struct PublishEntry {
    static constexpr char const* schema_name = "PublishEntry";

    std::string model_name{}; // What the entry is called.
    bool is_public{}; // Whether others see the entry, and whether it has a rank.
    std::optional<std::string> model_type{}; // What kind of model it is, for example `VLA` or `diffusion policy`.
    std::optional<std::string> organisation{};
    std::optional<std::string> homepage{}; // Where to read about the model.
    std::optional<std::string> code_url{}; // Where its code is.
    std::optional<std::string> notes{}; // Anything else, for readers.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("model_name", self.model_name);
        visitor.required("is_public", self.is_public);
        visitor.optional("model_type", self.model_type);
        visitor.optional("organisation", self.organisation);
        visitor.optional("homepage", self.homepage);
        visitor.optional("code_url", self.code_url);
        visitor.optional("notes", self.notes);
    }
};

} // namespace proctor
