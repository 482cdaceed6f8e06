/* Observations decoded from the text of JSON. */
#include "proctor/evaluate.h"

#include <algorithm>

namespace proctor {
namespace {

Error broken(std::string const& name, std::string const& what) {
    auto const detail = "The observation cannot be decoded: " + name + " " + what + ". Report it to the server's operator.";
    return Error("bad_answer", detail, false, "possible");
}

std::vector<std::uint8_t> bytes_of(std::string const& name, std::string const& base64) {
    static std::string const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static auto const values = [] {
        std::vector<int> table(256, -1);
        for (std::size_t i = 0; i < letters.size(); ++i) table[static_cast<unsigned char>(letters[i])] = static_cast<int>(i);
        return table;
    }();
    std::vector<std::uint8_t> bytes;
    bytes.reserve(base64.size() / 4 * 3);
    std::uint32_t word = 0;
    int bits = 0;
    for (unsigned char letter : base64) {
        if (letter == '=') break;
        if (values[letter] < 0) throw broken(name, "is no Base64");
        word = word << 6 | static_cast<std::uint32_t>(values[letter]);
        if ((bits += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(word >> (bits -= 8)));
    }
    return bytes;
}

/// Whether `bytes` is the product of the sizes, none of which is negative; safe from overflow.
bool is_product(std::size_t bytes, std::vector<std::int64_t> const& sizes) {
    if (std::any_of(sizes.begin(), sizes.end(), [](auto size) { return size < 0; })) return false;
    if (std::find(sizes.begin(), sizes.end(), 0) != sizes.end()) return bytes == 0;
    std::uint64_t product = 1;
    for (auto const size : sizes) {
        auto const factor = static_cast<std::uint64_t>(size);
        if (factor > bytes / product) return false;
        product *= factor;
    }
    return product == bytes;
}

/// Bytes of one number; 0 for a dtype of a later version.
std::size_t width_of(std::string const& dtype) {
    if (dtype == "bool" || dtype == "uint8" || dtype == "int8") return 1;
    if (dtype == "uint16" || dtype == "int16" || dtype == "float16") return 2;
    if (dtype == "uint32" || dtype == "int32" || dtype == "float32") return 4;
    return dtype == "uint64" || dtype == "int64" || dtype == "float64" ? 8 : 0;
}

} // namespace

PolicyInput decode(Observation const& seen) {
    PolicyInput input{};
    input.state = seen.state;
    for (auto const& [name, image] : seen.images) {
        auto data = bytes_of(name, image.data);
        if (image.codec == "raw" && !is_product(data.size(), {image.height, image.width, image.channels}))
            throw broken(name, "does not have its declared size");
        input.images[name] = {image.codec, image.height, image.width, image.channels, std::move(data)};
    }
    for (auto const& [name, tensor] : seen.tensors) {
        auto const width = width_of(tensor.dtype);
        if (width == 0) continue; // of a later version: left out
        auto sizes = tensor.shape;
        sizes.push_back(static_cast<std::int64_t>(width));
        auto bytes = bytes_of(name, tensor.data);
        if (!is_product(bytes.size(), sizes)) throw broken(name, "does not have its declared size");
        input.tensors[name] = {tensor.dtype, tensor.shape, std::move(bytes)};
    }
    return input;
}

} // namespace proctor
