/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

// ============================================================================
// Validation and numeric helper types for schema-aware branch validation.
//
// These types are shared between model and API templates. They support:
//  - Side-effect-free branch validation via ValidationResult/ValidationPath
//  - Mathematical JSON Schema numeric semantics (isJsonInteger, etc.)
//  - ECMA-262 regex subset for pattern validation
//  - Destination-bounded numeric conversion (convertJsonNumber)
// ============================================================================

#ifndef PROCTOR_MODEL_VALIDATION_TYPES_H_
#define PROCTOR_MODEL_VALIDATION_TYPES_H_

#include <boost/beast/http/status.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <regex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <boost/json.hpp>
// The exact-JSON runtime lives beside this header and supplies the wire
// lexeme recovery used by tryGetMathematicalInteger's double branch. There
// is no cycle: Oas31ExactJson.h does not include this header.
#include "Oas31ExactJson.h"

namespace proctor {
namespace model {

// ============================================================================
// Decode-time composition validation knob.
//
// kValidateOnDecode gates ONLY the composition-branch schema validation
// (oneOf exactly-one / anyOf at-least-one / discriminator branch checks in
// model-source.mustache). It is a compile-time constant so the skipped
// branches are eliminated by the optimizer for high-throughput clients that
// do not want composition validation on every decode.
//
// INVARIANT (M-contract, F3): representation diagnostics survive the knob.
// Non-finite destination checks, integer range checks ("not exact"), and all
// transport/representation failures still throw on BOTH paths. The knob
// never disables representation diagnostics — it only skips schema-validity
// membership counting. See docs/cpp-boost-beast-client-typed-mapping.md §1a.
//
// The emitted value is controlled by the codegen option
// `compileWithValidation` (default true); setting it to false emits
// `kValidateOnDecode = false` here. See CppBoostBeastClientCodegen.
// ============================================================================
constexpr bool kValidateOnDecode = true;

// ============================================================================
// ValidationPath — accumulates JSON path segments during validation recursion.
// Passed by reference; mutated to reflect current location in the instance.
// ============================================================================
struct ValidationPath {
    std::string path_;

    ValidationPath() = default;

    explicit ValidationPath(std::string path) : path_(std::move(path)) {}

    /// Enter a named object property segment.
    ValidationPath& enter(std::string const& segment) {
        if (path_.empty()) {
            path_ = segment;
        } else {
            path_.push_back('.');
            path_.append(segment);
        }
        return *this;
    }

    /// Enter an array index segment.
    ValidationPath& enterIndex(std::size_t index) {
        path_.push_back('[');
        path_.append(std::to_string(index));
        path_.push_back(']');
        return *this;
    }

    /// Exit the last segment (pop to previous '.' or resize to before '[').
    ValidationPath& exit() {
        auto dotPos = path_.rfind('.');
        auto bracketPos = path_.rfind('[');
        if (bracketPos != std::string::npos
            && (dotPos == std::string::npos || bracketPos > dotPos)) {
            // Pop array index segment
            path_.resize(bracketPos);
        } else if (dotPos != std::string::npos) {
            path_.resize(dotPos);
        } else {
            path_.clear();
        }
        return *this;
    }

    std::string const& str() const { return path_; }
    bool empty() const { return path_.empty(); }
};

// ============================================================================
// ValidationResult — carries the outcome of a schema branch validation.
// side-effect free; does not perform any C++ conversion.
// ============================================================================
struct ValidationResult {
    bool success;
    std::string failurePath;
    std::string failureMessage;

    static ValidationResult valid() {
        return ValidationResult{true, std::string(), std::string()};
    }

    static ValidationResult invalid(std::string path, std::string message) {
        return ValidationResult{false, std::move(path), std::move(message)};
    }

    static ValidationResult invalidAt(ValidationPath const& path, std::string message);
};

inline ValidationResult ValidationResult::invalidAt(ValidationPath const& path, std::string message) {
    return ValidationResult{false, path.str(), std::move(message)};
}

// ============================================================================
// Numeric helpers — mathematical JSON Schema semantics.
// ============================================================================

/// Returns true if the value is any JSON number (int64, uint64, or double).
inline bool isJsonNumber(boost::json::value const& v) {
    switch (v.kind()) {
        case boost::json::kind::int64:
        case boost::json::kind::uint64:
            return true;
        case boost::json::kind::double_:
            return std::isfinite(v.as_double());
        default:
            return false;
    }
}

/// Returns true if the value is a mathematical integer.
/// 1 and 1.0 both satisfy; non-integral doubles do not.
/// Standalone NaN/infinity are rejected as not integers.
inline bool isJsonInteger(boost::json::value const& v) {
    switch (v.kind()) {
        case boost::json::kind::int64:
        case boost::json::kind::uint64:
            return true;
        case boost::json::kind::double_: {
            double d = v.as_double();
            if (!std::isfinite(d)) return false;
            double integralPart;
            return std::modf(d, &integralPart) == 0.0;
        }
        default:
            return false;
    }
}

/// Attempts to extract a mathematical integer into a checked destination.
/// Returns false when the value is not integral or exceeds destination bounds.
/// A double is a trustworthy integer image only inside the doubles' own
/// exact window, |value| <= 2^53. The upper edge stays open: +2^53 is also
/// the ties-to-even image of the token 9007199254740993, so accepting it
/// would decode a different wire integer as the image. The lower edge is
/// open only for a destination reaching the precision boundary (int64),
/// whose -2^53 image is likewise ambiguous with -9007199254740993; for a
/// narrower signed destination the full range lies inside the exact
/// window, so the destination's own minimum image is accepted.
/// (For an unsigned destination the window's lower edge is zero, and zero
/// is never the image of a different integral token — +0.0 and -0.0 both
/// name the integer 0 — so zero stays accepted there.) Above the window
/// every double IS integral (modf says 0) yet the token that produced it may
/// already have been rounded at parse time, and every cast-based exactness
/// check then agrees with the rounded image. Inside an ExactInstanceScope
/// the wire lexeme is authoritative and is consulted FIRST, before any
/// image-based check: it converts exactly (9007199254740993.0 names an
/// integer the binary image cannot; 1.0000000000000001 names a
/// non-integer the image cannot see). Outside any scope the window is
/// enforced and a value beyond it is refused rather than silently corrupted.
template <typename T>
bool tryGetMathematicalInteger(boost::json::value const& v, T& out) {
    static_assert(std::is_integral_v<T>,
                  "tryGetMathematicalInteger requires an integral destination");
    switch (v.kind()) {
        case boost::json::kind::int64: {
            std::int64_t const raw = v.as_int64();
            if constexpr (std::is_signed_v<T>) {
                if (raw < static_cast<std::int64_t>((std::numeric_limits<T>::min)())
                        || raw > static_cast<std::int64_t>((std::numeric_limits<T>::max)())) {
                    return false;
                }
            } else {
                if (raw < 0 || static_cast<std::uint64_t>(raw)
                        > static_cast<std::uint64_t>((std::numeric_limits<T>::max)())) {
                    return false;
                }
            }
            out = static_cast<T>(raw);
            return true;
        }
        case boost::json::kind::uint64: {
            std::uint64_t const raw = v.as_uint64();
            if (raw > static_cast<std::uint64_t>((std::numeric_limits<T>::max)())) {
                return false;
            }
            out = static_cast<T>(raw);
            return true;
        }
        case boost::json::kind::double_: {
            // The wire lexeme outranks the binary image whenever it exists:
            // an image check would accept 1.0000000000000001 (which rounds to
            // the integer 1.0) and reject 9223372036854775807.0 (which rounds
            // past int64's maximum), inverting both verdicts. A lexeme beyond
            // the ExactNumber limit throws std::length_error; callers map
            // that to a payload error.
            if (std::string const* lexeme =
                    proctor::model::detail::schema_validation::exactNumericLexeme(v)) {
                return proctor::model::detail::schema_validation::exactLexemeToInteger(
                        *lexeme, out);
            }
            double const value = v.as_double();
            double integralPart;
            if (!std::isfinite(value)
                    || std::modf(value, &integralPart) != 0.0) {
                return false;
            }
            double const upperExclusive =
                    std::ldexp(1.0, std::numeric_limits<T>::digits);
            double const lowerInclusive = std::is_signed_v<T>
                    ? -upperExclusive : 0.0;
            if (integralPart < lowerInclusive
                    || integralPart >= upperExclusive) {
                return false;
            }
            int const trustDigits = (std::min)(
                    std::numeric_limits<T>::digits,
                    std::numeric_limits<double>::digits);
            double const trustUpper = std::ldexp(1.0, trustDigits);
            // Inside the exact window every double image names exactly one
            // integer, so the window may span the destination's own bounds.
            // Upper stays open: images at or past 2^digits are ambiguous
            // once the destination reaches the precision boundary (int64's
            // 2^63 edge). Lower closes to -2^digits only when the signed
            // destination's full range fits inside the window — otherwise
            // int32 would refuse its very own minimum, -2^31, whose image
            // is unambiguous. Unsigned: the zero edge is unambiguous, so
            // 0.0 / -0.0 stay accepted.
            bool const rangeFitsExactly = std::is_signed_v<T>
                    && std::numeric_limits<T>::digits
                            < std::numeric_limits<double>::digits;
            double const trustLower = std::is_signed_v<T>
                    ? (rangeFitsExactly ? -trustUpper : -std::nextafter(trustUpper, 0.0))
                    : 0.0;
            if (integralPart >= trustLower && integralPart < trustUpper) {
                out = static_cast<T>(integralPart);
                return true;
            }
            // At or past the trust window with no lexeme to recover the
            // token from: fail closed rather than return a possibly rounded
            // image.
            return false;
        }
        default:
            return false;
    }
}

/// Converts a JSON number to the requested C++ type.
/// Destination bounds are checked; throw on out-of-range or non-finite double.
template <typename T>
T convertJsonNumber(boost::json::value const& v) {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>,
                  "convertJsonNumber requires a numeric destination");
    if constexpr (std::is_integral_v<T>) {
        T converted{};
        if (!tryGetMathematicalInteger(v, converted)) {
            throw std::overflow_error(
                    "convertJsonNumber: value is not representable as the destination integer");
        }
        return converted;
    } else {
        double source;
        switch (v.kind()) {
            case boost::json::kind::int64:
                source = static_cast<double>(v.as_int64());
                break;
            case boost::json::kind::uint64:
                source = static_cast<double>(v.as_uint64());
                break;
            case boost::json::kind::double_:
                source = v.as_double();
                break;
            default:
                throw std::invalid_argument(
                        "convertJsonNumber: value is not a JSON number");
        }
        if (!std::isfinite(source)
                || source < static_cast<double>((std::numeric_limits<T>::lowest)())
                || source > static_cast<double>((std::numeric_limits<T>::max)())) {
            throw std::overflow_error(
                    "convertJsonNumber: value is outside the destination range");
        }
        return static_cast<T>(source);
    }
}

// ============================================================================
// Type-kind validation helpers
// ============================================================================

/// Returns true if the value is a JSON null.
inline bool isJsonNull(boost::json::value const& v) { return v.is_null(); }

/// Returns true if the value is a JSON boolean.
inline bool isJsonBoolean(boost::json::value const& v) { return v.is_bool(); }

/// Returns true if the value is a JSON string.
inline bool isJsonString(boost::json::value const& v) { return v.is_string(); }

/// Returns true if the value is a JSON array.
inline bool isJsonArray(boost::json::value const& v) { return v.is_array(); }

/// Returns true if the value is a JSON object.
inline bool isJsonObject(boost::json::value const& v) { return v.is_object(); }

/// Runtime type-name dispatch for schema validation.
/// Returns true when the instance matches the specified JSON Schema type name.
/// Supported type names: "string", "integer", "number", "boolean", "array",
/// "object", "null". For "integer", uses mathematical integer semantics.
/// For "number", accepts any JSON number (int64, uint64, or finite double).
inline bool checkJsonType(boost::json::value const& instance,
                          std::string const& typeName) {
    if (typeName == "string") return isJsonString(instance);
    if (typeName == "integer") return isJsonInteger(instance);
    if (typeName == "number") return isJsonNumber(instance);
    if (typeName == "boolean") return isJsonBoolean(instance);
    if (typeName == "array") return isJsonArray(instance);
    if (typeName == "object") return isJsonObject(instance);
    if (typeName == "null") return isJsonNull(instance);
    return true; // unknown type name: pass through
}

// ============================================================================
// Enum/const validation
// ============================================================================

/// Validates a JSON string against a set of allowed enum values.
inline bool validateEnumString(boost::json::value const& instance,
                               std::initializer_list<std::string> allowed) {
    if (!instance.is_string()) return false;
    auto const& sv = instance.as_string();
    for (auto const& candidate : allowed) {
        if (sv == candidate) return true;
    }
    return false;
}

/// Validates a JSON integer against a set of allowed values.
template <typename EnumType>
bool validateEnumInt(boost::json::value const& instance,
                     std::initializer_list<EnumType> allowed) {
    if (!instance.is_int64()) return false;
    auto raw = instance.as_int64();
    for (auto candidate : allowed) {
        if (raw == static_cast<std::int64_t>(candidate)) return true;
    }
    return false;
}

// ============================================================================
// ECMA-262 regex subset for pattern validation
//
// Supports the interoperable subset recommended by JSON Schema Core:
//   - Literal characters and escaped tokens
//   - Anchors (^ and $)
//   - Character classes [...] and [^...]
//   - Repetition: ?, +, *, {n}, {n,}, {n,m}
//   - Alternation: |
//   - Groups: (...)
//   - Shorthand classes: \d, \D, \w, \W, \s, \S
//
// Falls back to std::regex with ECMAScript grammar for the supported
// subset. Unsupported constructs (lookahead, backreferences, flags)
// cause a fail-closed result.
// ============================================================================

/// Validates a JSON string against a JSON Schema pattern.
/// Returns true on match, or throws if the pattern uses an unsupported
/// ECMA-262 construct (fail-closed).
inline bool validatePattern(boost::json::value const& instance,
                            std::string const& pattern) {
    if (!instance.is_string()) return false;
    std::string input(instance.as_string().data(), instance.as_string().size());
    try {
        std::regex re(pattern, std::regex::ECMAScript);
        return std::regex_search(input, re);
    } catch (std::regex_error const&) {
        // Pattern uses constructs outside the supported ECMA-262 subset.
        // Fail closed: reject the value rather than accepting silently.
        throw std::invalid_argument(
            "Unsupported ECMA-262 pattern construct: '" + pattern + "'");
    }
}

// ============================================================================
// CompositionBranchValue — tagged wrapper for duplicate C++ branch types.
//
// When multiple oneOf/anyOf branches resolve to the same C++ type (e.g., two
// double branches with different numeric constraints), std::variant deduplicates
// them, losing schema identity. CompositionBranchValue<BranchIndex, ValueType>
// preserves distinct branches by wrapping each in a unique C++ tag.
//
// Struct is trivially constructible/convertible for simplicity. BranchIndex
// matches the descriptor branch-index in the OAS composition structure.
// ============================================================================

template <std::size_t BranchIndex, typename ValueType>
struct CompositionBranchValue {
    ValueType value;

    CompositionBranchValue() = default;

    explicit CompositionBranchValue(ValueType v)
        : value(std::move(v)) {}
};

// ============================================================================
// Hash support for CompositionBranchValue wrapping (required by some containers).
// ============================================================================

template <std::size_t BranchIndex, typename ValueType>
struct CompositionBranchHash;

// SFINAE: enable CompositionBranchValue unwrapping for VariantJsonHelper.
// Used by template specializations to detect CompositionBranchValue types.
template <typename T>
struct IsCompositionBranchValue : std::false_type {};

template <std::size_t Idx, typename Val>
struct IsCompositionBranchValue<CompositionBranchValue<Idx, Val>> : std::true_type {};

// ============================================================================
// StatusTaggedValue — tagged response wrapper for status-distinct bodies.
//
// When two operation response statuses share the same C++ body type (e.g.,
// both 200 and 201 return FullResource), status-tagged wrappers preserve
// the distinct status identity in the response variant.
// ============================================================================

template <boost::beast::http::status StatusCode, typename ValueType>
struct StatusTaggedValue {
    static constexpr auto status_code = StatusCode;
    ValueType value;

    StatusTaggedValue() = default;

    explicit StatusTaggedValue(ValueType v)
        : value(std::move(v)) {}
};

}
}

#endif /* PROCTOR_MODEL_VALIDATION_TYPES_H_ */
