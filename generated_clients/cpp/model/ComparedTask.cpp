/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

// ============================================================================
// Validation scope (client-side vs full JSON Schema validation)
// ============================================================================
// The generated client performs structural and composition validation to
// ensure wire-format correctness, but is NOT a full JSON Schema meta-schema
// validator:
//
//   ✓ oneOf exactly-one match enforcement (shared schema evaluator per branch)
//   ✓ anyOf at-least-one match enforcement (shared schema evaluator per branch)
//   ✓ discriminator value enforcement (unknown → fall through to structural)
//   ✓ type validation, incl. type arrays with a literal "null" member
//   ✓ mathematical integer semantics (1 and 1.0 both accepted as integer)
//   ✓ enum / const membership, incl. deep (array/object) JSON members
//   ✓ boolean value-schemas (true always matches, false never matches)
//   ✓ required property presence in object JSON
//   ✓ numeric range validation (minimum, maximum, exclusiveMin, exclusiveMax)
//   ✓ numeric multipleOf validation (exact decimal lexemes)
//   ✓ string length validation (minLength, maxLength)
//   ✓ string pattern validation (ECMA-262 regex subset; fail-closed outside)
//   ✓ patternProperties and propertyNames
//   ✓ additionalProperties (false → reject; typed schemas densified)
//   ✓ array length (minItems / maxItems), items and prefixItems validation
//   ✓ array uniqueItems validation
//   ✓ minProperties / maxProperties (exact count bounds)
//   ✓ dependentRequired, contains (min/maxContains as exact count bounds)
//   ✓ `not` subschemas via the shared IR evaluator
//   ✓ if/then/else subschemas densified into the IR (bare unreferenced
//     conditionals are annotated, not asserted)
//   ✓ nested error-path diagnostics (e.g. ".field[0].nested")
//
//   Annotation-only per JSON Schema 2020-12 §8.2.6 (no output assertions):
//   format, contentEncoding, contentMediaType, contentSchema, $comment, and
//   other annotation-vocabulary keywords. Unknown keywords are preserved as
//   annotations and never affect accept/reject verdicts.
//
// For full JSON Schema validation, use a dedicated validator library
// (e.g. valijson, nlohmann/json-schema-validator) on the deserialized
// value before application use. The client's checks guarantee correct
// parse/serialization of valid instances matching the generated types.
// ============================================================================

#include "ComparedTask.h"

#include <cstddef>
#include <cstdint>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <sstream>
#include <string>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>
#include <boost/json.hpp>

#include "ValidationTypes.h"
#include "Oas31ExactJson.h"
#include "Oas31Validator.h"
#include "Oas31SchemaRegistry.h"

namespace proctor {
namespace model {

namespace {

// Trait to detect types with toJsonValue() const member.
template <typename T, typename = void>
struct HasModelToJsonValue : std::false_type {};

template <typename T>
struct HasModelToJsonValue<T, std::void_t<decltype(std::declval<const T&>().toJsonValue())>> : std::true_type {};

// Trait: detects whether a type has fromJsonValue member
template <typename T, typename = void>
struct HasFromJsonValueMethod : std::false_type {};

template <typename T>
struct HasFromJsonValueMethod<T,
    std::void_t<decltype(std::declval<T&>().fromJsonValue(std::declval<const boost::json::value&>()))>>
    : std::true_type {};

// Trait: detects specialization of a template
template <typename T, template <typename...> class Template>
struct IsSpecialization : std::false_type {};

template <template <typename...> class Template, typename... Args>
struct IsSpecialization<Template<Args...>, Template> : std::true_type {};

// Forward declarations for variant dispatch helpers (defined below).
template<typename Variant, std::size_t I>
bool tryVariantIndex(const boost::json::value& value, Variant& result, std::string* errorPath = nullptr);

template<typename Variant, std::size_t... Is>
bool tryVariantBranches(const boost::json::value& value, Variant& result, std::index_sequence<Is...>, std::string* errorPath = nullptr);

template<typename Variant, std::size_t... Is>
std::size_t countVariantBranches(const boost::json::value& value, std::index_sequence<Is...>, std::string* errorPath = nullptr);

// Try to parse a variant branch from JSON. Returns true on success.
// errorPath accumulates a JSON-path string (e.g. ".field[0].nested")
// for richer error messages in nested oneOf/anyOf parsing.
template<typename T>
bool tryParseBranch(boost::json::value const& value, T& result, std::string* errorPath = nullptr) {
    try {
        if constexpr (std::is_same_v<T, std::string>) {
            if (!value.is_string()) return false;
            result = boost::json::value_to<std::string>(value);
            return true;
        } else if constexpr (std::is_same_v<T, bool>) {
            if (!value.is_bool()) return false;
            result = boost::json::value_to<bool>(value);
            return true;
        } else if constexpr (std::is_same_v<T, std::int32_t>) {
            std::int64_t raw;
            if (!tryGetMathematicalInteger(value, raw)) return false;
            if (raw < (std::numeric_limits<std::int32_t>::min)() || raw > (std::numeric_limits<std::int32_t>::max)()) return false;
            result = static_cast<std::int32_t>(raw);
            return true;
        } else if constexpr (std::is_same_v<T, std::uint8_t>) {
            std::int64_t raw;
            if (!tryGetMathematicalInteger(value, raw)) return false;
            if (raw < 0 || raw > 255) return false;
            result = static_cast<std::uint8_t>(raw);
            return true;
        } else if constexpr (std::is_same_v<T, std::int64_t>) {
            return tryGetMathematicalInteger(value, result);
        } else if constexpr (std::is_same_v<T, double>) {
            if (value.is_double()) { result = value.as_double(); return true; }
            if (value.is_int64()) { result = static_cast<double>(value.as_int64()); return true; }
            if (value.is_uint64()) { result = static_cast<double>(value.as_uint64()); return true; }
            return false;
        } else if constexpr (std::is_same_v<T, boost::json::value>) {
            result = value;
            return true;
        } else if constexpr (std::is_same_v<T, std::nullptr_t>) {
            if (!value.is_null()) return false;
            result = nullptr;
            return true;
        } else if constexpr (IsSpecialization<T, std::vector>{}) {
            if (!value.is_array()) return false;
            using Elem = typename T::value_type;
            T vec;
            std::size_t elemIndex = 0;
            for (auto& elemVal : value.as_array()) {
                Elem converted;
                std::string itemPath;
                if (errorPath) {
                    itemPath = *errorPath + "[" + std::to_string(elemIndex) + "]";
                }
                if (!tryParseBranch(elemVal, converted, errorPath ? &itemPath : nullptr)) {
                    if (errorPath) {
                        *errorPath = std::move(itemPath);
                    }
                    return false;
                }
                vec.push_back(std::move(converted));
                ++elemIndex;
            }
            result = std::move(vec);
            return true;
        } else if constexpr (IsSpecialization<T, std::optional>{}) {
            if (value.is_null()) { result = std::nullopt; return true; }
            using Inner = typename T::value_type;
            Inner converted;
            if (!tryParseBranch(value, converted, errorPath)) return false;
            result = std::move(converted);
            return true;
        } else if constexpr (IsSpecialization<T, std::variant>{}) {
            // Nested variant — dispatch through tryVariantBranches, which
            // calls tryParseBranch for each alternative and picks the first
            // that matches. The fallback for each alternative checks for a
            // member fromJsonValue() method, so model-class branches (which
            // have one) or variant branches (which recurse) parse correctly.
            constexpr std::size_t variantSize = std::variant_size_v<T>;
            if (!tryVariantBranches(value, result, std::make_index_sequence<variantSize>{}, errorPath)) {
                return false;
            }
            return true;
        } else if constexpr (IsSpecialization<T, std::map>{}) {
            // std::map<std::string, MappedType> — iterate object entries.
            if (!value.is_object()) return false;
            using MappedType = typename T::mapped_type;
            T m;
            for (auto& entry : value.as_object()) {
                MappedType converted;
                std::string itemPath;
                if (errorPath) {
                    itemPath = *errorPath + "[\"" + std::string(entry.key()) + "\"]";
                }
                if (!tryParseBranch(entry.value(), converted, errorPath ? &itemPath : nullptr)) {
                    if (errorPath) {
                        *errorPath = std::move(itemPath);
                    }
                    return false;
                }
                m.emplace(std::string(entry.key()), std::move(converted));
            }
            result = std::move(m);
            return true;
        } else if constexpr (IsCompositionBranchValue<T>{}) {
            // CompositionBranchValue<Idx, Inner> — unwrap, parse inner, rewrap.
            using InnerType = decltype(T::value);
            InnerType inner;
            if (!tryParseBranch(value, inner, errorPath)) return false;
            result.value = std::move(inner);
            return true;
        } else {
            // Model type — try fromJsonValue member.
            // Do NOT swallow model validation errors (required field, type
            // mismatch, discriminator): propagate them via errorPath so the
            // caller can include them in the final diagnostic.
            if constexpr (HasFromJsonValueMethod<T>{}) {
                T candidate;
                try {
                    candidate.fromJsonValue(value);
                } catch (std::exception const& ex) {
                    if (errorPath) {
                        errorPath->append(": ").append(ex.what());
                    }
                    return false;
                }
                result = std::move(candidate);
                return true;
            } else {
                return false;
            }
        }
    } catch (...) {
        return false;
    }
}

template<typename Variant, std::size_t I>
bool tryVariantIndex(const boost::json::value& value, Variant& result, std::string* errorPath) {
    using BranchType = std::variant_alternative_t<I, Variant>;
    BranchType candidate;
    if (tryParseBranch(value, candidate, errorPath)) {
        result = std::move(candidate);
        return true;
    }
    return false;
}

template<typename Variant, std::size_t... Is>
bool tryVariantBranches(const boost::json::value& value, Variant& result, std::index_sequence<Is...>, std::string* errorPath) {
    const std::string initialErrorPath = errorPath == nullptr ? std::string() : *errorPath;
    std::string bestErrorPath = initialErrorPath;
    auto tryBranch = [&](auto branchIndex) {
        std::string branchErrorPath = initialErrorPath;
        if (tryVariantIndex<Variant, decltype(branchIndex)::value>(
                value, result, errorPath == nullptr ? nullptr : &branchErrorPath)) {
            return true;
        }
        if (branchErrorPath.size() > bestErrorPath.size()) {
            bestErrorPath = std::move(branchErrorPath);
        }
        return false;
    };
    const bool matched = (tryBranch(std::integral_constant<std::size_t, Is>{}) || ...);
    if (!matched && errorPath != nullptr) {
        *errorPath = std::move(bestErrorPath);
    }
    return matched;
}

// Count how many variant branches match the JSON value (no short-circuit).
// For oneOf, this is needed to reject >1 matches.
template<typename Variant, std::size_t... Is>
std::size_t countVariantBranches(const boost::json::value& value, std::index_sequence<Is...>, std::string* errorPath) {
    std::size_t count = 0;
    Variant temp;
    const std::string initialErrorPath = errorPath == nullptr ? std::string() : *errorPath;
    std::string bestErrorPath = initialErrorPath;
    auto countBranch = [&](auto branchIndex) {
        std::string branchErrorPath = initialErrorPath;
        if (tryVariantIndex<Variant, decltype(branchIndex)::value>(
                value, temp, errorPath == nullptr ? nullptr : &branchErrorPath)) {
            ++count;
        } else if (branchErrorPath.size() > bestErrorPath.size()) {
            bestErrorPath = std::move(branchErrorPath);
        }
    };
    (countBranch(std::integral_constant<std::size_t, Is>{}), ...);
    if (count == 0 && errorPath != nullptr) {
        *errorPath = std::move(bestErrorPath);
    }
    return count;
}

// Helper: dispatch toJsonValue based on whether T has a toJsonValue() member.
template <typename T>
boost::json::value jsonValueConverterToJsonValue(const T& val, std::true_type) {
    return val.toJsonValue();
}

template <typename T>
boost::json::value jsonValueConverterToJsonValue(const T& val, std::false_type) {
    return boost::json::value_from(val);
}

// Helper: dispatch fromJsonValue based on whether T has a fromJsonValue member.
template <typename T>
T jsonValueConverterFromJsonValue(const boost::json::value& jv, std::true_type) {
    T result;
    result.fromJsonValue(jv);
    return result;
}

template <typename T>
T jsonValueConverterFromJsonValue(const boost::json::value& jv, std::false_type) {
    return boost::json::value_to<T>(jv);
}

template <typename Target>
struct JsonValueConverter
{
    static boost::json::value toJsonValue(const Target& sourceValue)
    {
        return jsonValueConverterToJsonValue(sourceValue, HasModelToJsonValue<Target>{});
    }

    static Target fromJsonValue(const boost::json::value& jsonValue)
    {
        return jsonValueConverterFromJsonValue<Target>(jsonValue, HasFromJsonValueMethod<Target>{});
    }
};

// Composition tags preserve schema identity but do not appear on the wire.
template <std::size_t BranchIndex, typename ValueType>
struct JsonValueConverter<CompositionBranchValue<BranchIndex, ValueType>>
{
    static boost::json::value toJsonValue(
        const CompositionBranchValue<BranchIndex, ValueType>& sourceValue)
    {
        return JsonValueConverter<ValueType>::toJsonValue(sourceValue.value);
    }

    static CompositionBranchValue<BranchIndex, ValueType> fromJsonValue(
        const boost::json::value& jsonValue)
    {
        return CompositionBranchValue<BranchIndex, ValueType>{
            JsonValueConverter<ValueType>::fromJsonValue(jsonValue)};
    }
};

// Floating destinations must reject non-finite narrowing. Boost.JSON converts
// out-of-range values to infinity, but that value is not representable under
// the generated model's destination contract.
// Finite in-range input is converted normally.
template <>
struct JsonValueConverter<float>
{
    static boost::json::value toJsonValue(const float& sourceValue)
    {
        return boost::json::value_from(sourceValue);
    }

    static float fromJsonValue(const boost::json::value& jsonValue)
    {
        float result = boost::json::value_to<float>(jsonValue);
        if (!std::isfinite(result)) {
            throw std::invalid_argument(
                "Decode failed: value not representable as float "
                "(non-finite destination)");
        }
        return result;
    }
};

template <>
struct JsonValueConverter<double>
{
    static boost::json::value toJsonValue(const double& sourceValue)
    {
        return boost::json::value_from(sourceValue);
    }

    static double fromJsonValue(const boost::json::value& jsonValue)
    {
        double result = boost::json::value_to<double>(jsonValue);
        if (!std::isfinite(result)) {
            throw std::invalid_argument(
                "Decode failed: value not representable as double "
                "(non-finite destination)");
        }
        return result;
    }
};

// Integer destinations honour the exact wire lexeme when the decode runs
// inside an ExactInstanceScope (see tryGetMathematicalInteger). Plain
// value_to<std::int64_t> would accept the ROUNDED double image of any
// integral token above 2^53 — 9007199254740993.0 arriving as ...92 —
// because its static_cast equality check agrees with the image.
template <>
struct JsonValueConverter<std::int64_t>
{
    static boost::json::value toJsonValue(const std::int64_t& sourceValue)
    {
        return boost::json::value_from(sourceValue);
    }

    static std::int64_t fromJsonValue(const boost::json::value& jsonValue)
    {
        std::int64_t result = 0;
        if (!tryGetMathematicalInteger(jsonValue, result)) {
            throw std::invalid_argument(
                "Decode failed: value not representable as int64 "
                "(non-integral, out of range, or past the exact window "
                "with no wire lexeme to recover from)");
        }
        return result;
    }
};

template <>
struct JsonValueConverter<std::nullptr_t>
{
    static boost::json::value toJsonValue(std::nullptr_t)
    {
        return nullptr;
    }

    static std::nullptr_t fromJsonValue(const boost::json::value& jsonValue)
    {
        if (!jsonValue.is_null()) {
            throw std::invalid_argument("Expected a null JSON value");
        }
        return nullptr;
    }
};

// Specialization for std::optional — delegates to the inner type if set,
// otherwise produces null.
template <typename T>
struct JsonValueConverter<std::optional<T>>
{
    static boost::json::value toJsonValue(const std::optional<T>& opt)
    {
        if (opt.has_value()) {
            return JsonValueConverter<T>::toJsonValue(opt.value());
        }
        return nullptr;
    }

    static std::optional<T> fromJsonValue(const boost::json::value& jsonValue)
    {
        if (jsonValue.is_null()) {
            return std::nullopt;
        }
        return JsonValueConverter<T>::fromJsonValue(jsonValue);
    }
};

template <typename ModelType>
struct JsonValueConverter<std::shared_ptr<ModelType>>
{
    static boost::json::value toJsonValue(const std::shared_ptr<ModelType>& model)
    {
        if (model == nullptr) {
            return boost::json::value(nullptr);
        }
        return toJsonValueImpl(*model, HasModelToJsonValue<ModelType>{});
    }

    static std::shared_ptr<ModelType> fromJsonValue(const boost::json::value& jsonValue)
    {
        if (jsonValue.is_null()) {
            return nullptr;
        }
        return fromJsonValueImpl(jsonValue, HasModelToJsonValue<ModelType>{});
    }

private:
    static boost::json::value toJsonValueImpl(const ModelType& val, std::true_type) {
        return val.toJsonValue();
    }
    static boost::json::value toJsonValueImpl(const ModelType& val, std::false_type) {
        return boost::json::value_from(val);
    }

    static std::shared_ptr<ModelType> fromJsonValueImpl(const boost::json::value& jv, std::true_type) {
        return std::make_shared<ModelType>(jv);
    }
    static std::shared_ptr<ModelType> fromJsonValueImpl(const boost::json::value& jv, std::false_type) {
        return std::make_shared<ModelType>(boost::json::value_to<ModelType>(jv));
    }
};

template <typename Element>
struct JsonValueConverter<std::vector<Element>>
{
    static boost::json::value toJsonValue(const std::vector<Element>& sourceValues)
    {
        boost::json::array jsonValues;
        for (const auto& sourceValue : sourceValues) {
            jsonValues.emplace_back(JsonValueConverter<Element>::toJsonValue(sourceValue));
        }
        return jsonValues;
    }

    static std::vector<Element> fromJsonValue(const boost::json::value& jsonValue)
    {
        const auto& jsonValues = jsonValue.as_array();
        std::vector<Element> convertedValues;
        convertedValues.reserve(jsonValues.size());
        for (const auto& jsonElement : jsonValues) {
            convertedValues.emplace_back(JsonValueConverter<Element>::fromJsonValue(jsonElement));
        }
        return convertedValues;
    }
};

// anyOf-compatible first-match decode for property-level / untagged variants.
// Named oneOf aliases use free functions with exactly-one enforcement.
// Inline oneOf properties call fromJsonValueExactlyOne via the object template.
template <typename Variant>
Variant fromJsonValueFirstMatch(const boost::json::value& jsonValue)
{
    constexpr std::size_t variantSize = std::variant_size_v<Variant>;
    Variant result;
    std::string errorPath;
    if (!tryVariantBranches(jsonValue, result, std::make_index_sequence<variantSize>{}, &errorPath)) {
        throw std::invalid_argument("No matching variant branch for JSON value at '" + errorPath + "'");
    }
    return result;
}

template <typename Variant>
Variant fromJsonValueExactlyOne(const boost::json::value& jsonValue)
{
    constexpr std::size_t variantSize = std::variant_size_v<Variant>;
    std::size_t matchCount = countVariantBranches<Variant>(
        jsonValue, std::make_index_sequence<variantSize>{});
    if (matchCount == 0) {
        Variant dummy;
        std::string capturePath;
        tryVariantBranches(jsonValue, dummy, std::make_index_sequence<variantSize>{}, &capturePath);
        throw std::invalid_argument("No matching variant branch for JSON value at '" + capturePath + "'");
    }
    if (matchCount > 1) {
        throw std::invalid_argument("More than one matching variant branch for JSON value");
    }
    Variant result;
    std::string retrievePath;
    if (!tryVariantBranches(jsonValue, result, std::make_index_sequence<variantSize>{}, &retrievePath)) {
        throw std::invalid_argument("No matching variant branch for JSON value at '" + retrievePath + "'");
    }
    return result;
}

template <typename... Ts>
struct JsonValueConverter<std::variant<Ts...>>
{
    static boost::json::value toJsonValue(const std::variant<Ts...>& v)
    {
        return std::visit([](auto const& alt) -> boost::json::value {
            using AltType = std::decay_t<decltype(alt)>;
            return JsonValueConverter<AltType>::toJsonValue(alt);
        }, v);
    }

    static std::variant<Ts...> fromJsonValue(const boost::json::value& jsonValue)
    {
        // Default property-level path: anyOf first-match (≥1). oneOf exactly-one
        // is applied by named free functions or fromJsonValueExactlyOne when the
        // property is a oneOf composition (exactly-one branch semantics).
        return fromJsonValueFirstMatch<std::variant<Ts...>>(jsonValue);
    }
};

template <typename MappedValue>
struct JsonValueConverter<std::map<std::string, MappedValue>>
{
    static boost::json::value toJsonValue(const std::map<std::string, MappedValue>& sourceValues)
    {
        boost::json::object jsonValues;
        for (const auto& sourceEntry : sourceValues) {
            jsonValues[sourceEntry.first] = JsonValueConverter<MappedValue>::toJsonValue(sourceEntry.second);
        }
        return jsonValues;
    }

    static std::map<std::string, MappedValue> fromJsonValue(const boost::json::value& jsonValue)
    {
        std::map<std::string, MappedValue> convertedValues;
        for (const auto& jsonEntry : jsonValue.as_object()) {
            const std::string entryKey(jsonEntry.key().data(), jsonEntry.key().size());
            convertedValues.emplace(entryKey, JsonValueConverter<MappedValue>::fromJsonValue(jsonEntry.value()));
        }
        return convertedValues;
    }
};

void writePrettyJson(std::ostream& output, boost::json::value const& value, std::string& indent)
{
    if (value.is_object()) {
        const auto& object = value.as_object();
        if (object.empty()) {
            output << "{}";
            return;
        }

        output << "{\n";
        indent.append(4, ' ');
        for (auto iterator = object.begin(); iterator != object.end(); ++iterator) {
            output << indent << boost::json::serialize(iterator->key()) << ": ";
            writePrettyJson(output, iterator->value(), indent);
            if (std::next(iterator) != object.end()) {
                output << ',';
            }
            output << '\n';
        }
        indent.resize(indent.size() - 4);
        output << indent << '}';
        return;
    }

    if (value.is_array()) {
        const auto& array = value.as_array();
        if (array.empty()) {
            output << "[]";
            return;
        }

        output << "[\n";
        indent.append(4, ' ');
        for (auto iterator = array.begin(); iterator != array.end(); ++iterator) {
            output << indent;
            writePrettyJson(output, *iterator, indent);
            if (std::next(iterator) != array.end()) {
                output << ',';
            }
            output << '\n';
        }
        indent.resize(indent.size() - 4);
        output << indent << ']';
        return;
    }

    output << boost::json::serialize(value);
}
}



ComparedTask::ComparedTask(boost::json::value const& value)
{
    fromJsonValue(value);
}

std::string ComparedTask::toJsonString(bool prettyJson /* = false */) const
{
    const auto value = toJsonValue();
    if (!prettyJson) {
        return boost::json::serialize(value);
    }

    std::ostringstream output;
    std::string indent;
    writePrettyJson(output, value, indent);
    return output.str();
}

void ComparedTask::fromJsonString(std::string const& jsonString)
{
    proctor::model::detail::schema_validation::ExactJsonValue exactJson = proctor::model::detail::schema_validation::parseExactJson(jsonString);
    proctor::model::detail::schema_validation::requireModelConvertibleJson(exactJson);
    proctor::model::detail::schema_validation::ExactInstanceScope exactScope(exactJson);
    fromJsonValue(exactJson.value);
}

boost::json::value ComparedTask::toJsonValue() const
{
    return boost::json::value(toJsonObject_internal());
}

void ComparedTask::fromJsonValue(boost::json::value const& value)
{
    m_extraJsonProperties.clear();
    if (!value.is_object()) {
        throw std::invalid_argument("Expected a JSON object for ComparedTask");
    }
    boost::json::object const& object = value.as_object();
    fromJsonObject_internal(object);
    for (auto const& member : object) {
        if (!isKnownJsonProperty(member.key())) {
            m_extraJsonProperties.emplace(
                std::string(member.key().data(), member.key().size()), member.value());
        }
    }
}

ComparedTask fromJsonValue_ComparedTask(boost::json::value const& value)
{
    ComparedTask result;
    result.fromJsonValue(value);
    return result;
}

bool ComparedTask::isKnownJsonProperty(boost::json::string_view name) const
{
    return false
        || name == "paired"
        || name == "baseline_mean"
        || name == "mean"
        || name == "difference"
        ;
}

boost::json::object ComparedTask::toJsonObject_internal() const
{
    boost::json::object object;
    for (auto const& extraJsonProperty : m_extraJsonProperties) {
        boost::json::string_view const name(
            extraJsonProperty.first.data(), extraJsonProperty.first.size());
        if (!isKnownJsonProperty(name)) {
            object[name] = extraJsonProperty.second;
        }
    }

        object["paired"] = JsonValueConverter<std::int32_t>::toJsonValue(getPaired());
        object["baseline_mean"] = JsonValueConverter<std::optional<double>>::toJsonValue(getBaselineMean());
        object["mean"] = JsonValueConverter<std::optional<double>>::toJsonValue(getMean());
        object["difference"] = JsonValueConverter<std::optional<double>>::toJsonValue(getDifference());
    return object;
}

void ComparedTask::fromJsonObject_internal(boost::json::object const& object)
{
    m_Paired = {};
    m_Baseline_mean.reset();
    m_Mean.reset();
    m_Difference.reset();
    {
        const auto PairedIt = object.find("paired");
        if (PairedIt != object.end()) {
            if (!PairedIt->value().is_null()) {
            try {
                setPaired(JsonValueConverter<std::int32_t>::fromJsonValue(PairedIt->value()));
            } catch (std::exception const& ex) {
                throw std::invalid_argument(
                    "Decode failed for 'paired' in ComparedTask: " + std::string(ex.what()));
            }
            }
        } else {
            throw std::invalid_argument("Required field 'paired' not found in ComparedTask");
        }
    }
    {
        const auto Baseline_meanIt = object.find("baseline_mean");
        if (Baseline_meanIt != object.end()) {
            try {
                setBaselineMean(JsonValueConverter<std::optional<double>>::fromJsonValue(Baseline_meanIt->value()));
            } catch (std::exception const& ex) {
                throw std::invalid_argument(
                    "Decode failed for 'baseline_mean' in ComparedTask: " + std::string(ex.what()));
            }
        } else {
            throw std::invalid_argument("Required field 'baseline_mean' not found in ComparedTask");
        }
    }
    {
        const auto MeanIt = object.find("mean");
        if (MeanIt != object.end()) {
            try {
                setMean(JsonValueConverter<std::optional<double>>::fromJsonValue(MeanIt->value()));
            } catch (std::exception const& ex) {
                throw std::invalid_argument(
                    "Decode failed for 'mean' in ComparedTask: " + std::string(ex.what()));
            }
        } else {
            throw std::invalid_argument("Required field 'mean' not found in ComparedTask");
        }
    }
    {
        const auto DifferenceIt = object.find("difference");
        if (DifferenceIt != object.end()) {
            try {
                setDifference(JsonValueConverter<std::optional<double>>::fromJsonValue(DifferenceIt->value()));
            } catch (std::exception const& ex) {
                throw std::invalid_argument(
                    "Decode failed for 'difference' in ComparedTask: " + std::string(ex.what()));
            }
        } else {
            throw std::invalid_argument("Required field 'difference' not found in ComparedTask");
        }
    }
}

std::int32_t ComparedTask::getPaired() const
{
    return m_Paired;
}

void ComparedTask::setPaired(std::int32_t value)
{

    m_Paired = std::move(value);
}
std::optional<double> ComparedTask::getBaselineMean() const
{
    return m_Baseline_mean;
}

void ComparedTask::setBaselineMean(std::optional<double> value)
{

    m_Baseline_mean = std::move(value);
}
std::optional<double> ComparedTask::getMean() const
{
    return m_Mean;
}

void ComparedTask::setMean(std::optional<double> value)
{

    m_Mean = std::move(value);
}
std::optional<double> ComparedTask::getDifference() const
{
    return m_Difference;
}

void ComparedTask::setDifference(std::optional<double> value)
{

    m_Difference = std::move(value);
}

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ComparedTask>>& data)
{
    return boost::json::serialize(JsonValueConverter<std::vector<std::shared_ptr<ComparedTask>>>::toJsonValue(data));
}

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ComparedTask>>& vec, const std::string& json)
{
    proctor::model::detail::schema_validation::ExactJsonValue exactJson = proctor::model::detail::schema_validation::parseExactJson(json);
    proctor::model::detail::schema_validation::requireModelConvertibleJson(exactJson);
    proctor::model::detail::schema_validation::ExactInstanceScope exactScope(exactJson);
    vec = JsonValueConverter<std::vector<std::shared_ptr<ComparedTask>>>::fromJsonValue(exactJson.value);
}

}
}
