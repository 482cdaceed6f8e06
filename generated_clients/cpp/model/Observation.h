/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "Tensor.h"
#include <map>
#include "Image.h"
#include <vector>
#include "../members.h"

namespace proctor {


struct Observation {
    static constexpr char const* schema_name = "Observation";

    std::map<std::string, std::vector<double>> state{};
    std::map<std::string, Image> images{};
    std::map<std::string, Tensor> tensors{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("state", self.state);
        visitor.required("images", self.images);
        visitor.required("tensors", self.tensors);
    }
};

} // namespace proctor
