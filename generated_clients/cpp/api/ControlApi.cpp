/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */


#include <cctype>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <cstdint>
#include <limits>
#include <functional>
#include <map>
#include <array>
#include <algorithm>
#include <utility>
#include <vector>
#include <optional>
#include <variant>
#include <random>

#include <boost/beast/http/status.hpp>
#include <boost/version.hpp>
#include <boost/beast/core/detail/base64.hpp>
#include <boost/algorithm/string.hpp>
#include <boost/json.hpp>
#include <boost/optional.hpp>

#include "../model/ValidationTypes.h"
#include "../model/Oas31ExactJson.h"

#include "ControlApi.h"


namespace proctor {
namespace api {


using namespace proctor::model;

namespace {
std::string selectPreferredContentType(const std::vector<std::string>& contentTypes) {
    if (contentTypes.size() == 1) {
        return contentTypes.at(0);
    }

    static const std::array<std::string, 1> preferredTypes = {"json"};
    for (const auto& preferredType: preferredTypes) {
        const auto ret = std::find_if(contentTypes.cbegin(),
                                      contentTypes.cend(),
                                      [preferredType](const std::string& str) {
                                            return str.find(preferredType) != std::string::npos;});
        if (ret != contentTypes.cend()) {
            return *ret;
        }
    }

    if (contentTypes.size() == 0) {
        return "application/json";
    }

    return contentTypes.at(0);
}

inline std::string normalizeMediaType(const std::string& contentType) {
    const auto parameterSeparator = contentType.find(';');
    std::string mediaType = contentType.substr(0, parameterSeparator);
    boost::algorithm::trim(mediaType);
    boost::algorithm::to_lower(mediaType);
    return mediaType;
}

[[maybe_unused]] inline bool isJsonContentType(const std::string& contentType) {
    const std::string mediaType = normalizeMediaType(contentType);
    return mediaType == "application/json"
        || (mediaType.size() > 5 && mediaType.compare(mediaType.size() - 5, 5, "+json") == 0);
}
}


template<typename T>
bool hasFormParameterValue(const T&) noexcept {
    return true;
}

template<typename T>
bool hasFormParameterValue(const std::shared_ptr<T>& value) noexcept {
    return value != nullptr;
}

template<typename T>
bool hasFormParameterValue(const std::optional<T>& value) noexcept {
    return value.has_value();
}

template<typename T>
bool hasFormParameterValue(const boost::optional<T>& value) noexcept {
    return value.has_value();
}


inline std::string toFormParameterValue(const std::string& value) {
    return value;
}

inline std::string toFormParameterValue(bool value) {
    return value ? "true" : "false";
}

inline std::string toRawBodyValue(const std::string& value) {
    return value;
}

inline std::string toRawBodyValue(bool value) {
    return value ? "true" : "false";
}

template<typename T>
std::string toRawBodyValue(const T& value) {
    std::ostringstream stream;
    stream << value;
    return stream.str();
}

template<typename T>
std::string toRawBodyValue(const std::optional<T>& value) {
    if (value.has_value()) {
        return toRawBodyValue(value.value());
    }
    return "";
}

// Generic toFormParameterValue: uses operator<< for arithmetic types,
// JSON serialization for object/map types via toRequestJsonValue.
template<typename T, typename = void>
struct FormParamSerializer {
    static std::string serialize(const T& value) {
        std::ostringstream stream;
        stream << value;
        return stream.str();
    }
};

// Map types serialize as JSON after the request converter overloads are defined.
template<typename T>
struct FormParamSerializer<std::map<std::string, T>, void> {
    static std::string serialize(const std::map<std::string, T>& mapValue);
};

// Detect types with toJsonValue() member — model classes.
template <typename T, typename = void>
struct HasFormToJsonValue : std::false_type {};

template <typename T>
struct HasFormToJsonValue<T, std::void_t<
    decltype(std::declval<const T&>().toJsonValue())>> : std::true_type {};

template<typename T>
std::string toFormParameterValue(const std::shared_ptr<T>& value);

template<typename... Ts>
std::string toFormParameterValue(const std::variant<Ts...>& value);

template<std::size_t BranchIndex, typename ValueType>
std::string toFormParameterValue(
    const CompositionBranchValue<BranchIndex, ValueType>& value);

template<typename T>
std::string toFormParameterValue(const std::optional<T>& value);

template<typename T>
typename std::enable_if<HasFormToJsonValue<T>::value, std::string>::type
toFormParameterValue(const std::vector<T>& values);

template<typename T>
typename std::enable_if<!HasFormToJsonValue<T>::value, std::string>::type
toFormParameterValue(const std::vector<T>& values);

// Model classes: serialize via toJsonValue() as JSON.
template<typename T>
typename std::enable_if<HasFormToJsonValue<T>::value, std::string>::type
toFormParameterValue(const T& value) {
    return boost::json::serialize(value.toJsonValue());
}

// Fallback for types without toJsonValue() — operator<< or map serializer.
template<typename T>
typename std::enable_if<!HasFormToJsonValue<T>::value, std::string>::type
toFormParameterValue(const T& value) {
    return FormParamSerializer<T>::serialize(value);
}

template<typename T>
std::string toFormParameterValue(const std::shared_ptr<T>& value) {
    return value == nullptr ? "" : toFormParameterValue(*value);
}

template<typename... Ts>
std::string toFormParameterValue(const std::variant<Ts...>& value) {
    return std::visit([](const auto& alternative) -> std::string {
        return toFormParameterValue(alternative);
    }, value);
}

template<std::size_t BranchIndex, typename ValueType>
std::string toFormParameterValue(
    const CompositionBranchValue<BranchIndex, ValueType>& value) {
    return toFormParameterValue(value.value);
}

template<typename T>
std::string toFormParameterValue(const std::optional<T>& value) {
    if (value.has_value()) {
        return toFormParameterValue(value.value());
    }
    return "";
}

// Arrays of model types (HasFormToJsonValue): serialize as JSON array.
template<typename T>
typename std::enable_if<HasFormToJsonValue<T>::value, std::string>::type
toFormParameterValue(const std::vector<T>& values) {
    boost::json::array jsonArray;
    for (const auto& value : values) {
        jsonArray.push_back(value.toJsonValue());
    }
    return boost::json::serialize(jsonArray);
}

// Arrays of types without toJsonValue: comma-delimited (OAS form-style).
template<typename T>
typename std::enable_if<!HasFormToJsonValue<T>::value, std::string>::type
toFormParameterValue(const std::vector<T>& values) {
    std::stringstream serializedValues;
    const char* separator = "";
    for (const auto& value : values) {
        serializedValues << separator << toFormParameterValue(value);
        separator = ",";
    }
    return serializedValues.str();
}

// Binary data: treat the byte values as raw string content for file upload.
inline std::string toFormParameterValue(const std::vector<std::uint8_t>& binaryValue) {
    return std::string(reinterpret_cast<const char*>(binaryValue.data()), binaryValue.size());
}

inline std::string percentEncodeFormValue(const std::string& value) {
    static const char hexDigits[] = "0123456789ABCDEF";
    std::string encodedValue;
    encodedValue.reserve(value.size());
    for (const unsigned char character : value) {
        if ((character >= 'a' && character <= 'z')
            || (character >= 'A' && character <= 'Z')
            || (character >= '0' && character <= '9')
            || character == '-' || character == '.' || character == '_'
            || character == '~') {
            encodedValue.push_back(static_cast<char>(character));
        } else if (character == ' ') {
            encodedValue.push_back('+');
        } else {
            encodedValue.push_back('%');
            encodedValue.push_back(hexDigits[(character >> 4) & 0x0F]);
            encodedValue.push_back(hexDigits[character & 0x0F]);
        }
    }
    return encodedValue;
}

inline std::string percentEncodeRfc3986Value(const std::string& unencodedValue) {
    static const char hexDigits[] = "0123456789ABCDEF";
    std::string encodedValue;
    encodedValue.reserve(unencodedValue.size());
    for (const unsigned char character : unencodedValue) {
        if ((character >= 'a' && character <= 'z')
            || (character >= 'A' && character <= 'Z')
            || (character >= '0' && character <= '9')
            || character == '-' || character == '.' || character == '_'
            || character == '~') {
            encodedValue.push_back(static_cast<char>(character));
        } else {
            encodedValue.push_back('%');
            encodedValue.push_back(hexDigits[(character >> 4) & 0x0F]);
            encodedValue.push_back(hexDigits[character & 0x0F]);
        }
    }
    return encodedValue;
}

inline std::string percentEncodePathValue(const std::string& unencodedValue) {
    return percentEncodeRfc3986Value(unencodedValue);
}

inline std::string percentEncodeQueryValue(const std::string& unencodedValue) {
    return percentEncodeRfc3986Value(unencodedValue);
}

// ---- OpenAPI parameter serialization --------------------------------------
// The wire layer is JSON-driven: every emitted parameter value converts to a
// boost::json::value (toJsonValue overloads below, incl. the generated
// parameter/model classes' toJsonValue()), then style/explode/allowReserved
// render it into the exact wire bytes of OAS 3.1 §Parameter Serialization.

// allowReserved=true: keep the RFC 3986 reserved set raw in the query value
// (:/?#[]@!$&'()*+,;=). Default (false) = strict percent-encoding.
// RFC 6570 reserved expansion also preserves well-formed pct-encoded triplets.
inline std::string percentEncodeQueryReservedValue(const std::string& unencodedValue) {
    static const char hexDigits[] = "0123456789ABCDEF";
    auto isHexDigit = [](unsigned char character) {
        return (character >= '0' && character <= '9')
            || (character >= 'A' && character <= 'F')
            || (character >= 'a' && character <= 'f');
    };
    std::string encodedValue;
    encodedValue.reserve(unencodedValue.size());
    for (std::size_t index = 0; index < unencodedValue.size(); ++index) {
        const unsigned char character =
            static_cast<unsigned char>(unencodedValue[index]);
        if (character == '%' && index + 2 < unencodedValue.size()
            && isHexDigit(static_cast<unsigned char>(unencodedValue[index + 1]))
            && isHexDigit(static_cast<unsigned char>(unencodedValue[index + 2]))) {
            encodedValue.append(unencodedValue, index, 3);
            index += 2;
        } else if ((character >= 'a' && character <= 'z')
            || (character >= 'A' && character <= 'Z')
            || (character >= '0' && character <= '9')
            || character == '-' || character == '.' || character == '_'
            || character == '~'
            || character == ':' || character == '/' || character == '?'
            || character == '#' || character == '[' || character == ']'
            || character == '@' || character == '!' || character == '$'
            || character == '&' || character == '\'' || character == '('
            || character == ')' || character == '*' || character == '+'
            || character == ',' || character == ';' || character == '=') {
            encodedValue.push_back(static_cast<char>(character));
        } else {
            encodedValue.push_back('%');
            encodedValue.push_back(hexDigits[(character >> 4) & 0x0F]);
            encodedValue.push_back(hexDigits[character & 0x0F]);
        }
    }
    return encodedValue;
}

inline boost::json::value toJsonValue(const boost::json::value& v) { return v; }
inline boost::json::value toJsonValue(const std::string& v) { return boost::json::value(v); }
inline boost::json::value toJsonValue(bool v) { return boost::json::value(v); }
inline boost::json::value toJsonValue(std::int32_t v) { return boost::json::value(v); }
inline boost::json::value toJsonValue(std::int64_t v) { return boost::json::value(v); }
inline boost::json::value toJsonValue(double v) { return boost::json::value(v); }
template<typename T>
boost::json::value toJsonValue(const std::vector<T>& value);

template<typename ValueType>
boost::json::value toJsonValue(const std::map<std::string, ValueType>& value);

template<typename T>
boost::json::value toJsonValue(const std::shared_ptr<T>& value);

template<typename T>
boost::json::value toJsonValue(const std::optional<T>& value);

template<typename... Ts>
boost::json::value toJsonValue(const std::variant<Ts...>& value);

template<std::size_t BranchIndex, typename ValueType>
boost::json::value toJsonValue(
    const CompositionBranchValue<BranchIndex, ValueType>& value);

template<typename T>
boost::json::value toJsonValue(const T& value);

template<typename T>
boost::json::value toJsonValue(const std::vector<T>& v) {
    boost::json::array a;
    a.reserve(v.size());
    for (const auto& e : v) { a.emplace_back(toJsonValue(e)); }
    return boost::json::value(std::move(a));
}
template<typename V>
boost::json::value toJsonValue(const std::map<std::string, V>& m) {
    boost::json::object o;
    for (const auto& kv : m) { o[kv.first] = toJsonValue(kv.second); }
    return boost::json::value(std::move(o));
}
template<typename T>
boost::json::value toJsonValue(const std::shared_ptr<T>& value) {
    return value == nullptr ? boost::json::value(nullptr) : toJsonValue(*value);
}
template<typename T>
boost::json::value toJsonValue(const std::optional<T>& value) {
    return value.has_value() ? toJsonValue(*value) : boost::json::value(nullptr);
}
template<typename... Ts>
boost::json::value toJsonValue(const std::variant<Ts...>& value) {
    return std::visit([](const auto& alternative) -> boost::json::value {
        return toJsonValue(alternative);
    }, value);
}
template<std::size_t BranchIndex, typename ValueType>
boost::json::value toJsonValue(
    const CompositionBranchValue<BranchIndex, ValueType>& value) {
    return toJsonValue(value.value);
}
template<typename T>
boost::json::value toJsonValue(const T& value) {
    if constexpr (HasFormToJsonValue<T>::value) {
        return value.toJsonValue();
    }
    // Legacy/exotic types degrade to the ostringstream string form.
    return boost::json::value(toFormParameterValue(value));
}

inline std::string jsonScalarText(const boost::json::value& v) {
    if (v.is_string()) { return std::string(v.as_string()); }
    return boost::json::serialize(v);   // numbers, booleans, null
}

// ---- Operation server precedence ------------------------------------------
inline std::string serverPathPrefix(const std::string& serverUrl) {
    // The HttpClientImpl owns the connection (scheme, host, port); the API
    // layer always passes origin-form targets. An absolute server URL
    // contributes only its PATH prefix; a server host different from the
    // caller's HttpClient configuration must be pointed at by the caller
    // (documented seam). Relative server URLs are normalized to origin form.
    std::string s = serverUrl;
    const std::string authoritySeparator = "://";
    const std::size_t authority = s.find(authoritySeparator);
    if (authority != std::string::npos) {
        const std::size_t slash = s.find('/', authority + authoritySeparator.size());
        s = slash == std::string::npos ? std::string() : s.substr(slash);
    }
    if (!s.empty() && s.front() != '/') {
        s.insert(s.begin(), '/');
    }
    // drop trailing slashes (the request path always begins with '/'),
    // including the lone root slash ('' is the correct empty prefix)
    while (!s.empty() && s.back() == '/') { s.pop_back(); }
    return s;
}

inline std::string operationServerPrefix(const std::string& context,
                                         const std::string& resolvedServer) {
    return resolvedServer.empty() ? context : serverPathPrefix(resolvedServer);
}

// ---- query: form / spaceDelimited / pipeDelimited / deepObject -----------
template<typename T>
void appendParamQueryParameter(
    std::stringstream& queryParameterStream,
    const char*& queryParameterSeparator,
    const std::string& parameterName,
    const T& parameterValue,
    const std::string& style,
    bool explode,
    bool allowReserved,
    bool allowEmptyValue) {
    const boost::json::value v = toJsonValue(parameterValue);
    // Empty-value policy (3.1): without allowEmptyValue an empty string value
    // is omitted entirely.
    if (!allowEmptyValue && v.is_string() && v.as_string().empty()) {
        return;
    }
    const std::string encodedName = percentEncodeQueryValue(parameterName);
    auto enc = [&](const std::string& s) {
        return allowReserved ? percentEncodeQueryReservedValue(s)
                             : percentEncodeQueryValue(s);
    };
    auto appendRaw = [&](const std::string& name, const std::string& value) {
        queryParameterStream << queryParameterSeparator << name << '=' << value;
        queryParameterSeparator = "&";
    };
    if (style == "deepObject" && v.is_object()) {
        // OAS deepObject uses raw brackets as structural delimiters while the
        // parameter and member names remain percent-encoded.
        for (const auto& member : v.as_object()) {
            appendRaw(encodedName + "["
                          + percentEncodeQueryValue(std::string(member.key())) + "]",
                      enc(jsonScalarText(member.value())));
        }
        return;
    }
    if (style == "form" || style == "spaceDelimited" || style == "pipeDelimited") {
        // Wire delimiters: form uses a raw comma; spaceDelimited/pipeDelimited
        // join with the ENCODED delimiter (%20 / %7C) — the raw space or pipe
        // is not valid in a query string and must never appear on the wire.
        const char* styleDelimiter =
            style == "spaceDelimited" ? "%20" :
            style == "pipeDelimited"  ? "%7C" : ",";
        if (explode) {
            if (v.is_array()) {
                for (const auto& element : v.as_array()) {
                    appendRaw(encodedName, enc(jsonScalarText(element)));
                }
            } else if (v.is_object()) {
                // form explode=true object: k=v&k2=v2 — no base name
                for (const auto& member : v.as_object()) {
                    appendRaw(percentEncodeQueryValue(std::string(member.key())),
                              enc(jsonScalarText(member.value())));
                }
            } else {
                appendRaw(encodedName, enc(jsonScalarText(v)));
            }
        } else {
            if (v.is_array()) {
                std::string joined;
                bool first = true;
                for (const auto& element : v.as_array()) {
                    if (!first) { joined += styleDelimiter; }
                    first = false;
                    joined += enc(jsonScalarText(element));
                }
                appendRaw(encodedName, joined);
            } else if (v.is_object()) {
                // form explode=false object: name=k,v,k2,v2
                std::string joined;
                bool first = true;
                for (const auto& member : v.as_object()) {
                    if (!first) { joined += styleDelimiter; }
                    first = false;
                    joined += enc(std::string(member.key()));
                    joined += styleDelimiter;
                    joined += enc(jsonScalarText(member.value()));
                }
                appendRaw(encodedName, joined);
            } else {
                appendRaw(encodedName, enc(jsonScalarText(v)));
            }
        }
        return;
    }
    // Unknown styles degrade to the form single-pair form (honest: the
    // codegen emits only the styles handled above).
    appendRaw(encodedName, enc(jsonScalarText(v)));
}

// ---- path: simple / label / matrix ---------------------------------------
inline std::string pathStyleValue(const boost::json::value& v,
                                  const std::string& style,
                                  bool explode,
                                  const std::string& parameterName) {
    auto enc = [](const std::string& s) { return percentEncodePathValue(s); };
    auto scalar = [&](const boost::json::value& e) { return enc(jsonScalarText(e)); };
    auto encKey = [&](const boost::json::string& key) {
        return enc(std::string(key));
    };
    std::string out;
    if (style == "label") {
        out += ".";
        if (explode && v.is_object()) {
            bool first = true;
            for (const auto& member : v.as_object()) {
                if (!first) { out += '.'; }
                first = false;
                out += encKey(member.key()) + '=' + scalar(member.value());
            }
        } else if (v.is_array()) {
            bool first = true;
            for (const auto& element : v.as_array()) {
                if (!first) { out += '.'; }
                first = false;
                out += scalar(element);
            }
        } else if (v.is_object()) {
            bool first = true;
            for (const auto& member : v.as_object()) {
                if (!first) { out += '.'; }
                first = false;
                out += encKey(member.key()) + '.' + scalar(member.value());
            }
        } else {
            out += scalar(v);
        }
    } else if (style == "matrix") {
        out += ';';
        if (explode && v.is_object()) {
            bool first = true;
            for (const auto& member : v.as_object()) {
                if (!first) { out += ';'; }
                first = false;
                out += encKey(member.key()) + '=' + scalar(member.value());
            }
        } else if (explode && v.is_array()) {
            bool first = true;
            for (const auto& element : v.as_array()) {
                if (!first) { out += ';'; }
                first = false;
                out += parameterName + '=' + scalar(element);
            }
        } else if (v.is_array()) {
            out += parameterName + '=';
            bool first = true;
            for (const auto& element : v.as_array()) {
                if (!first) { out += ','; }
                first = false;
                out += scalar(element);
            }
        } else if (v.is_object()) {
            out += parameterName + '=';
            bool first = true;
            for (const auto& member : v.as_object()) {
                if (!first) { out += ','; }
                first = false;
                out += encKey(member.key()) + ',' + scalar(member.value());
            }
        } else {
            out += parameterName + '=' + scalar(v);
        }
    } else {   // simple (path/header default)
        if (explode && v.is_object()) {
            bool first = true;
            for (const auto& member : v.as_object()) {
                if (!first) { out += ','; }
                first = false;
                out += encKey(member.key()) + '=' + scalar(member.value());
            }
        } else if (v.is_array()) {
            bool first = true;
            for (const auto& element : v.as_array()) {
                if (!first) { out += ','; }
                first = false;
                out += scalar(element);
            }
        } else if (v.is_object()) {
            bool first = true;
            for (const auto& member : v.as_object()) {
                if (!first) { out += ','; }
                first = false;
                out += encKey(member.key()) + ',' + scalar(member.value());
            }
        } else {
            out += scalar(v);
        }
    }
    return out;
}

template<typename T>
void replacePathParameter(
    std::string& path,
    const std::string& parameterName,
    const T& parameterValue,
    const std::string& style,
    bool explode) {
    const std::string placeholder = "{" + parameterName + "}";
    const std::string serializedValue =
        pathStyleValue(toJsonValue(parameterValue), style, explode, parameterName);
    std::string::size_type position = 0;
    while ((position = path.find(placeholder, position)) != std::string::npos) {
        path.replace(position, placeholder.size(), serializedValue);
        position += serializedValue.size();
    }
}

// ---- query single-value helpers (legacy call sites) ----------------------
template<typename T>
std::string serializeQueryParameterValue(const T& queryParameterValue) {
    return percentEncodeQueryValue(toFormParameterValue(queryParameterValue));
}

template<typename T>
std::string serializeQueryParameterValue(
    const std::vector<T>& queryParameterValues,
    const std::string& collectionDelimiter) {
    std::stringstream serializedValues;
    const char* separator = "";
    for (const T& queryParameterValue : queryParameterValues) {
        serializedValues << separator
                         << percentEncodeQueryValue(toFormParameterValue(queryParameterValue));
        separator = collectionDelimiter.c_str();
    }
    return serializedValues.str();
}

inline void appendQueryParameter(
    std::stringstream& queryParameterStream,
    const char*& queryParameterSeparator,
    const std::string& parameterName,
    const std::string& parameterValue) {
    queryParameterStream << queryParameterSeparator
                         << percentEncodeQueryValue(parameterName) << '='
                         << parameterValue;
    queryParameterSeparator = "&";
}

// ---- header: simple (objects exploded as k=v, pairs comma-delimited) -----
template<typename T>
std::string serializeHeaderParameterValue(const T& v, bool explode) {
    // RFC 7230 field values: never percent-encoded.
    const boost::json::value j = toJsonValue(v);
    auto scalar = [](const boost::json::value& e) { return jsonScalarText(e); };
    auto key = [](const boost::json::string& k) { return std::string(k); };
    std::string out;
    if (explode && j.is_object()) {
        bool first = true;
        for (const auto& member : j.as_object()) {
            if (!first) { out += ','; }
            first = false;
            out += key(member.key()) + '=' + scalar(member.value());
        }
    } else if (j.is_array()) {
        bool first = true;
        for (const auto& element : j.as_array()) {
            if (!first) { out += ','; }
            first = false;
            out += scalar(element);
        }
    } else if (j.is_object()) {
        bool first = true;
        for (const auto& member : j.as_object()) {
            if (!first) { out += ','; }
            first = false;
            out += key(member.key()) + ',' + scalar(member.value());
        }
    } else {
        out = scalar(j);
    }
    return out;
}

// ---- cookie: form style into the Cookie header (3.1) ---------------------
template<typename T>
void appendCookieParameter(
    std::string& cookieHeader,
    const std::string& parameterName,
    const T& parameterValue,
    bool explode) {
    const boost::json::value v = toJsonValue(parameterValue);
    auto encode = [](const std::string& value) {
        return percentEncodeRfc3986Value(value);
    };
    const std::string encodedName = encode(parameterName);
    auto scalar = [&](const boost::json::value& e) {
        return encode(jsonScalarText(e));
    };
    auto key = [&](const boost::json::string& k) {
        return encode(std::string(k));
    };
    auto push = [&](const std::string& pair) {
        if (!cookieHeader.empty()) { cookieHeader += "; "; }
        cookieHeader += pair;
    };
    if (explode) {
        if (v.is_array()) {
            if (v.as_array().empty()) { return; }   // empty = absent
            for (const auto& element : v.as_array()) {
                push(encodedName + '=' + scalar(element));
            }
        } else if (v.is_object()) {
            for (const auto& member : v.as_object()) {
                push(key(member.key()) + '=' + scalar(member.value()));
            }
        } else {
            push(encodedName + '=' + scalar(v));
        }
    } else {
        if (v.is_array()) {
            if (v.as_array().empty()) { return; }
            std::string joined;
            bool first = true;
            for (const auto& element : v.as_array()) {
                if (!first) { joined += ','; }
                first = false;
                joined += scalar(element);
            }
            push(encodedName + '=' + joined);
        } else if (v.is_object()) {
            std::string joined;
            bool first = true;
            for (const auto& member : v.as_object()) {
                if (!first) { joined += ','; }
                first = false;
                joined += key(member.key()) + ',' + scalar(member.value());
            }
            push(encodedName + '=' + joined);
        } else {
            push(encodedName + '=' + scalar(v));
        }
    }
}

// ---- header path (Void/raw helpers above; templates' header emission uses
//      serializeHeaderParameterValue(T, explode) defined earlier) ----------

inline std::string serializeUrlEncodedFormData(const std::vector<FormParameter>& formParameters) {
    std::stringstream serializedFormData;
    const char* separator = "";
    for (const auto& formParameter : formParameters) {
        serializedFormData << separator
                           << percentEncodeFormValue(formParameter.name)
                           << '='
                           << percentEncodeFormValue(formParameter.value);
        separator = "&";
    }
    return serializedFormData.str();
}


namespace {

std::string base64encodeImpl(const std::string& str) {
#if BOOST_VERSION < 107100
    return boost::beast::detail::base64_encode(str);
#else
    std::string encoded;
    encoded.resize(boost::beast::detail::base64::encoded_size(str.size()));
    if (!str.empty()) {
        encoded.resize(boost::beast::detail::base64::encode(&encoded[0], str.data(), str.size()));
    }
    return encoded;
#endif
}

// Trait to detect types with toJsonValue() const member (e.g. model classes)
template <typename T, typename = void>
struct HasRequestToJsonValue : std::false_type {};

template <typename T>
struct HasRequestToJsonValue<T, std::void_t<
    decltype(std::declval<const T&>().toJsonValue())>> : std::true_type {};

// Dispatch for types with toJsonValue() — model classes
template<typename T>
boost::json::value toRequestJsonValueImpl(const T& requestValue, std::true_type) {
    return requestValue.toJsonValue();
}

// Dispatch for types without toJsonValue() — primitives, standard containers
template<typename T>
boost::json::value toRequestJsonValueImpl(const T& requestValue, std::false_type) {
    return boost::json::value_from(requestValue);
}

// Base template: detect toJsonValue() at compile time and dispatch accordingly
template<typename T>
boost::json::value toRequestJsonValue(const T& requestValue) {
    return toRequestJsonValueImpl(requestValue, HasRequestToJsonValue<T>{});
}
template<typename T>
boost::json::value toRequestJsonValue(const std::shared_ptr<T>& requestValue);

template<typename T>
boost::json::value toRequestJsonValue(const std::vector<T>& requestValues);

template<typename T>
boost::json::value toRequestJsonValue(const std::map<std::string, T>& requestValues);

template<typename... Ts>
boost::json::value toRequestJsonValue(const std::variant<Ts...>& requestValue);

template<typename T>
boost::json::value toRequestJsonValue(const std::optional<T>& requestValue);

template<std::size_t BranchIndex, typename ValueType>
boost::json::value toRequestJsonValue(
    const CompositionBranchValue<BranchIndex, ValueType>& value);



template<typename T>
boost::json::value toRequestJsonValue(const std::shared_ptr<T>& requestValue) {
    return requestValue == nullptr
        ? boost::json::value(nullptr)
        : toRequestJsonValue(*requestValue);
}

template<typename... Ts>
boost::json::value toRequestJsonValue(const std::variant<Ts...>& requestValue) {
    return std::visit([](auto const& v) -> boost::json::value {
        return toRequestJsonValue(v);
    }, requestValue);
}

template<std::size_t Idx, typename Val>
boost::json::value toRequestJsonValue(const CompositionBranchValue<Idx, Val>& v) {
    return toRequestJsonValue(v.value);
}

template<typename T>
boost::json::value toRequestJsonValue(const std::optional<T>& requestValue) {
    if (requestValue.has_value()) {
        return toRequestJsonValue(requestValue.value());
    }
    return boost::json::value(nullptr);
}

template<typename T>
boost::json::value toRequestJsonValue(const std::vector<T>& requestValues) {
    boost::json::array requestArray;
    requestArray.reserve(requestValues.size());
    for (const auto& requestValue : requestValues) {
        requestArray.emplace_back(toRequestJsonValue(requestValue));
    }
    return requestArray;
}

template<typename T>
boost::json::value toRequestJsonValue(const std::map<std::string, T>& requestValues) {
    boost::json::object requestObject;
    for (const auto& requestEntry : requestValues) {
        requestObject.emplace(requestEntry.first, toRequestJsonValue(requestEntry.second));
    }
    return requestObject;
}

// ──────────────────────────────────────────────────────────────────────
// Multipart form parameter serialization helpers.
//
// serializeMultipartFormData produces wire-format multipart/form-data
// bodies per RFC 2046. Each FormParameter carries:
//   - name    : the part name (Content-Disposition form-data name)
//   - value   : the serialized part body
//   - isFile  : if true, adds filename and defaults to octet-stream
//   - contentType : explicit Content-Type override (Encoding Object)
//   - filename : caller-controlled file name (defaults to the part name)
//
// Content-Type precedence (OAS 3.0 §10.4):
//   1. Encoding Object contentType on the property
//   2. OAS default for the property type (octet-stream for binary)
// When no contentType is set and isFile is false, no Content-Type
// header is emitted for the part.
// ──────────────────────────────────────────────────────────────────────

/// Classifies variant storage by the OAS multipart default for its schema type.
/// CompositionBranchValue is transparent because its tag preserves schema
/// identity, not a distinct wire representation.
template<typename T>
struct MultipartVariantBranchTraits {
    static constexpr bool isBinary = false;
    static constexpr bool usesTextPlain = std::is_arithmetic_v<T>
        || std::is_enum_v<T>
        || std::is_same_v<T, std::string>;
};

template<typename T>
struct MultipartVariantBranchTraits<std::vector<T>> {
    static constexpr bool isBinary = std::is_same_v<T, std::uint8_t>;
    static constexpr bool usesTextPlain = !isBinary
        && MultipartVariantBranchTraits<T>::usesTextPlain;
};

template<typename T>
struct MultipartVariantBranchTraits<std::shared_ptr<T>>
    : MultipartVariantBranchTraits<T> {};

template<typename T>
struct MultipartVariantBranchTraits<std::optional<T>>
    : MultipartVariantBranchTraits<T> {};

template<typename T>
struct MultipartVariantBranchTraits<boost::optional<T>>
    : MultipartVariantBranchTraits<T> {};

template<std::size_t BranchIndex, typename ValueType>
struct MultipartVariantBranchTraits<CompositionBranchValue<BranchIndex, ValueType>>
    : MultipartVariantBranchTraits<ValueType> {};

/// addVariantFormParameter definition (forward-declared above).
/// Must be defined after toRequestJsonValue so lambdas can find it via ADL.
/// An Encoding Object contentType overrides the branch default. Otherwise,
/// primitive branches and arrays of primitives use text/plain, complex values
/// use application/json, and byte containers use application/octet-stream.
template<typename VariantType>
void addVariantFormParameter(
    std::vector<FormParameter>& formParameters,
    const std::string& name,
    const VariantType& value,
    const std::string& encodingContentType = "") {
    std::visit([&](auto const& branch) {
        using BranchType = std::decay_t<decltype(branch)>;
        using BranchTraits = MultipartVariantBranchTraits<BranchType>;
        if constexpr (BranchTraits::isBinary) {
            const std::string partContentType = encodingContentType.empty()
                ? "application/octet-stream" : encodingContentType;
            formParameters.emplace_back(name, toFormParameterValue(branch), true,
                                        partContentType, name);
        } else if constexpr (BranchTraits::usesTextPlain) {
            const std::string partContentType = encodingContentType.empty()
                ? "text/plain" : encodingContentType;
            formParameters.emplace_back(
                name, toFormParameterValue(branch), false, partContentType);
        } else {
            const std::string partContentType = encodingContentType.empty()
                ? "application/json" : encodingContentType;
            const std::string jsonValue =
                boost::json::serialize(toRequestJsonValue(branch));
            formParameters.emplace_back(name, jsonValue, false, partContentType);
        }
    }, value);
}

// Trait to detect types with fromJsonValue(boost::json::value const&) member
template <typename T, typename = void>
struct HasFromJsonValue : std::false_type {};

template <typename T>
struct HasFromJsonValue<T, std::void_t<
    decltype(std::declval<T&>().fromJsonValue(std::declval<boost::json::value const&>()))>> : std::true_type {};

// Dispatch for types with fromJsonValue() — model classes
template<typename T>
static T convertJsonValueImpl(const boost::json::value& responseValue, std::true_type) {
    T result;
    result.fromJsonValue(responseValue);
    return result;
}

// Dispatch for types without fromJsonValue() — primitives, standard types
template<typename T>
static T convertJsonValueImpl(const boost::json::value& responseValue, std::false_type) {
    return boost::json::value_to<T>(responseValue);
}

template<typename T>
struct ResponseJsonValueConverter {
    static T convert(const boost::json::value& responseValue) {
        return convertJsonValueImpl<T>(responseValue, HasFromJsonValue<T>{});
    }
};

template<>
struct ResponseJsonValueConverter<boost::json::value> {
    static boost::json::value convert(const boost::json::value& responseValue) {
        return responseValue;
    }
};

template<typename T>
struct ResponseJsonValueConverter<std::shared_ptr<T>> {
    static std::shared_ptr<T> convert(const boost::json::value& responseValue) {
        return responseValue.is_null() ? nullptr : std::make_shared<T>(ResponseJsonValueConverter<T>::convert(responseValue));
    }
};

template<typename T>
struct ResponseJsonValueConverter<std::vector<T>> {
    static std::vector<T> convert(const boost::json::value& responseValue) {
        const auto& responseArray = responseValue.as_array();
        std::vector<T> convertedValues;
        convertedValues.reserve(responseArray.size());
        for (const auto& arrayValue : responseArray) {
            convertedValues.emplace_back(ResponseJsonValueConverter<T>::convert(arrayValue));
        }
        return convertedValues;
    }
};

template<typename T>
struct ResponseJsonValueConverter<std::map<std::string, T>> {
    static std::map<std::string, T> convert(const boost::json::value& responseValue) {
        const auto& responseObject = responseValue.as_object();
        std::map<std::string, T> convertedValues;
        for (const auto& objectEntry : responseObject) {
            convertedValues.emplace(
                objectEntry.key_c_str(),
                ResponseJsonValueConverter<T>::convert(objectEntry.value()));
        }
        return convertedValues;
    }
};

// Trait: detects whether a type is a specialization of a template (e.g. std::vector<T>)
template <typename T, template <typename...> class Template>
struct IsSpecialization : std::false_type {};

template <template <typename...> class Template, typename... Args>
struct IsSpecialization<Template<Args...>, Template> : std::true_type {};

template<typename Variant, std::size_t I>
bool tryVariantAlternative(const boost::json::value& value, Variant& result);

template<typename Variant, std::size_t... Is>
bool tryFirstVariantAlternative(
    const boost::json::value& value,
    Variant& result,
    std::index_sequence<Is...>);

// Variant branch trial helpers — tries to parse a JSON value into a specific type.
// These are defined OUTSIDE the anonymous namespace so they can be referenced by
// ResponseJsonValueConverter specializations and SSE event conversion.
template<typename T>
bool tryParseBranch(const boost::json::value& value, T& result) {
    try {
        if constexpr (std::is_same_v<T, std::string>) {
            if (!value.is_string()) return false;
            result = boost::json::value_to<std::string>(value);
            return true;
        } else if constexpr (std::is_same_v<T, bool>) {
            if (!value.is_bool()) return false;
            result = boost::json::value_to<bool>(value);
            return true;
        } else if constexpr (std::is_same_v<T, std::uint8_t>) {
            std::int64_t raw;
            if (!tryGetMathematicalInteger(value, raw)) return false;
            if (raw < 0 || raw > 255) return false;
            result = static_cast<std::uint8_t>(raw);
            return true;
        } else if constexpr (std::is_same_v<T, std::int32_t>) {
            std::int64_t raw;
            if (!tryGetMathematicalInteger(value, raw)) return false;
            if (raw < (std::numeric_limits<std::int32_t>::min)() || raw > (std::numeric_limits<std::int32_t>::max)()) return false;
            result = static_cast<std::int32_t>(raw);
            return true;
        } else if constexpr (std::is_same_v<T, std::int64_t>) {
            return tryGetMathematicalInteger(value, result);
        } else if constexpr (std::is_same_v<T, double>) {
            if (value.is_double()) { result = value.as_double(); return true; }
            if (value.is_int64()) { result = static_cast<double>(value.as_int64()); return true; }
            if (value.is_uint64()) { result = static_cast<double>(value.as_uint64()); return true; }
            return false;
        } else if constexpr (std::is_same_v<T, float>) {
            double converted;
            if (!tryParseBranch(value, converted)
                    || !std::isfinite(converted)
                    || converted < static_cast<double>((std::numeric_limits<float>::lowest)())
                    || converted > static_cast<double>((std::numeric_limits<float>::max)())) {
                return false;
            }
            result = static_cast<float>(converted);
            return true;
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
            for (auto& elemVal : value.as_array()) {
                Elem converted;
                if (!tryParseBranch(elemVal, converted)) return false;
                vec.push_back(std::move(converted));
            }
            result = std::move(vec);
            return true;
        } else if constexpr (IsSpecialization<T, std::optional>{}) {
            if (value.is_null()) { result = std::nullopt; return true; }
            using Inner = typename T::value_type;
            Inner converted;
            if (!tryParseBranch(value, converted)) return false;
            result = std::move(converted);
            return true;
        } else if constexpr (IsSpecialization<T, std::variant>{}) {
            constexpr std::size_t variantSize = std::variant_size_v<T>;
            return tryFirstVariantAlternative(
                value, result, std::make_index_sequence<variantSize>{});
        } else if constexpr (IsSpecialization<T, std::map>{}) {
            if (!value.is_object()) return false;
            using MappedType = typename T::mapped_type;
            T m;
            for (auto& entry : value.as_object()) {
                MappedType converted;
                if (!tryParseBranch(entry.value(), converted)) return false;
                m.emplace(std::string(entry.key()), std::move(converted));
            }
            result = std::move(m);
            return true;
        } else if constexpr (IsCompositionBranchValue<T>{}) {
            // CompositionBranchValue<Idx, Inner> — unwrap, parse inner, rewrap.
            using InnerType = decltype(T::value);
            InnerType inner;
            if (!tryParseBranch(value, inner)) return false;
            result.value = std::move(inner);
            return true;
        } else {
            // Model type with fromJsonValue member
            if constexpr (HasFromJsonValue<T>{}) {
                T candidate;
                candidate.fromJsonValue(value);
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
bool tryVariantAlternative(const boost::json::value& value, Variant& result) {
    using BranchType = std::variant_alternative_t<I, Variant>;
    BranchType candidate;
    if (tryParseBranch(value, candidate)) {
        result = std::move(candidate);
        return true;
    }
    return false;
}

template<typename Variant, std::size_t... Is>
bool tryFirstVariantAlternative(
    const boost::json::value& value,
    Variant& result,
    std::index_sequence<Is...>) {
    return (tryVariantAlternative<Variant, Is>(value, result) || ...);
}

template<typename Variant, std::size_t... Is>
bool tryAllVariantAlternatives(const boost::json::value& value, Variant& result, std::index_sequence<Is...>) {
    // Evaluate ALL alternatives without short-circuiting (comma-fold instead of ||-fold)
    // so ambiguous matches (multiple alternatives matching the same JSON value) are
    // properly detected and rejected. This enforces oneOf semantics: exactly one
    // alternative must match. Zero or >1 matches both fail.
    std::size_t matchCount = 0;
    ((matchCount += (tryVariantAlternative<Variant, Is>(value, result) ? 1 : 0)), ...);
    return matchCount == 1;
}

template<typename... Ts>
struct ResponseJsonValueConverter<std::variant<Ts...>> {
    static std::variant<Ts...> convert(const boost::json::value& responseValue) {
        std::variant<Ts...> result;
        if (!tryFirstVariantAlternative(responseValue, result, std::index_sequence_for<Ts...>{})) {
            throw std::invalid_argument(
                "JSON value does not match any variant alternative");
        }
        return result;
    }
};

template<typename T>
struct OneOfResponseJsonValueConverter {
    static T convert(const boost::json::value& responseValue) {
        return ResponseJsonValueConverter<T>::convert(responseValue);
    }
};

template<typename... Ts>
struct OneOfResponseJsonValueConverter<std::variant<Ts...>> {
    static std::variant<Ts...> convert(const boost::json::value& responseValue) {
        std::variant<Ts...> result;
        if (!tryAllVariantAlternatives(responseValue, result, std::index_sequence_for<Ts...>{})) {
            throw std::invalid_argument(
                "JSON value does not match exactly one variant alternative "
                "(oneOf semantics: zero or multiple alternatives matched)");
        }
        return result;
    }
};

template<typename T>
struct ResponseJsonValueConverter<std::optional<T>> {
    static std::optional<T> convert(const boost::json::value& responseValue) {
        if (responseValue.is_null()) {
            return std::nullopt;
        }
        return ResponseJsonValueConverter<T>::convert(responseValue);
    }
};

template<typename T, typename Converter>
void deserializeJsonResponseBody(
    T& convertedResponse,
    const std::string& responseBody,
    const std::string& responseContentType,
    bool tolerateEmptyBody,
    const Converter& converter) {
    if (!isJsonContentType(responseContentType)) {
        throw std::invalid_argument(
            "Content type '" + responseContentType + "' does not support structured response bodies");
    }
    if (tolerateEmptyBody && responseBody.empty()) {
        return;
    }
    proctor::model::detail::schema_validation::ExactJsonValue exactResponse = proctor::model::detail::schema_validation::parseExactJson(responseBody);
    proctor::model::detail::schema_validation::requireModelConvertibleJson(exactResponse);
    proctor::model::detail::schema_validation::ExactInstanceScope exactScope(exactResponse);
    convertedResponse = converter(exactResponse.value);
}

template<typename T>
struct ResponseBodyDeserializer {
    static void deserialize(
        T& convertedResponse,
        const std::string& responseBody,
        const std::string& responseContentType,
        bool tolerateEmptyBody) {
        deserializeJsonResponseBody(
            convertedResponse,
            responseBody,
            responseContentType,
            tolerateEmptyBody,
            [](boost::json::value const& responseValue) {
                return ResponseJsonValueConverter<T>::convert(responseValue);
            });
    }
};

template<>
struct ResponseBodyDeserializer<std::string> {
    static void deserialize(
        std::string& convertedResponse,
        const std::string& responseBody,
        const std::string&,
        bool) {
        convertedResponse = responseBody;
    }
};

template<typename T>
struct OneOfResponseBodyDeserializer : ResponseBodyDeserializer<T> {};

template<typename... Ts>
struct OneOfResponseBodyDeserializer<std::variant<Ts...>> {
    static void deserialize(
        std::variant<Ts...>& convertedResponse,
        const std::string& responseBody,
        const std::string& responseContentType,
        bool tolerateEmptyBody) {
        deserializeJsonResponseBody(
            convertedResponse,
            responseBody,
            responseContentType,
            tolerateEmptyBody,
            [](boost::json::value const& responseValue) {
                return OneOfResponseJsonValueConverter<std::variant<Ts...>>::convert(
                    responseValue);
            });
    }
};

}
template<typename T>
std::string FormParamSerializer<std::map<std::string, T>, void>::serialize(
    const std::map<std::string, T>& mapValue) {
    boost::json::object object;
    for (const auto& entry : mapValue) {
        object[entry.first] = toRequestJsonValue(entry.second);
    }
    return boost::json::serialize(object);
}


ControlApiException::ControlApiException(
    boost::beast::http::status statusCode,
    std::string what,
    std::string responseBody)
  : m_status(statusCode),
    m_what(std::move(what)),
    m_responseBody(std::move(responseBody))
{
}

boost::beast::http::status ControlApiException::getStatus() const
{
    return m_status;
}

const std::string& ControlApiException::getResponseBody() const noexcept
{
    return m_responseBody;
}

const char* ControlApiException::what() const noexcept
{
    return m_what.c_str();
}

std::shared_ptr<Comparison>
ControlApi::compareRuns(
    const std::string& baseline, const std::string& runs, const boost::optional<double>& tolerance, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/comparisons";
    std::map<std::string, std::string> headers;
    // Query parameters preserve style, explode, allowReserved, and allowEmptyValue.
    std::stringstream queryParameterStream;
    const char* queryParameterSeparator = "?";
        appendParamQueryParameter(
            queryParameterStream,
            queryParameterSeparator,
            "baseline",
            baseline,
            "form",
            true,
            false,
            false);
        appendParamQueryParameter(
            queryParameterStream,
            queryParameterSeparator,
            "runs",
            runs,
            "form",
            true,
            false,
            false);
    if (tolerance) {
        appendParamQueryParameter(
            queryParameterStream,
            queryParameterSeparator,
            "tolerance",
            *tolerance,
            "form",
            true,
            false,
            false);
    }
    path += queryParameterStream.str();
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("compareRuns", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Comparison> deserializedResponse = std::make_shared<Comparison>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<Comparison>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<Service>
ControlApi::describeService(
    const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1";
    std::map<std::string, std::string> headers;
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Service> deserializedResponse = std::make_shared<Service>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<Service>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<Benchmark>
ControlApi::getBenchmark(
    const std::string& benchmarkId, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/benchmarks/{benchmark_id}";
    std::map<std::string, std::string> headers;
    // Path parameters use their declared simple, label, or matrix style.
    replacePathParameter(path, "benchmark_id", benchmarkId, "simple", false);
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("getBenchmark", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Benchmark> deserializedResponse = std::make_shared<Benchmark>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<Benchmark>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<Run>
ControlApi::getRun(
    const std::string& runId, const std::string& ifNoneMatch, const std::string& prefer, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/runs/{run_id}";
    std::map<std::string, std::string> headers;
    // Path parameters use their declared simple, label, or matrix style.
    replacePathParameter(path, "run_id", runId, "simple", false);
    // headers
    headers.emplace("If-None-Match", serializeHeaderParameterValue(ifNoneMatch, false));
    headers.emplace("Prefer", serializeHeaderParameterValue(prefer, false));
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("getRun", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Run> deserializedResponse = std::make_shared<Run>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<Run>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (statusCode == boost::beast::http::status(304)) {
        throw ControlApiException(statusCode, "Unchanged since the ETag in If-None-Match.", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<Score>
ControlApi::getScore(
    const std::string& runId, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/runs/{run_id}/score";
    std::map<std::string, std::string> headers;
    // Path parameters use their declared simple, label, or matrix style.
    replacePathParameter(path, "run_id", runId, "simple", false);
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("getScore", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Score> deserializedResponse = std::make_shared<Score>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<Score>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<BenchmarkList>
ControlApi::listBenchmarks(
    const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/benchmarks";
    std::map<std::string, std::string> headers;
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("listBenchmarks", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<BenchmarkList> deserializedResponse = std::make_shared<BenchmarkList>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<BenchmarkList>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<EpisodeList>
ControlApi::listEpisodes(
    const std::string& runId, const boost::optional<std::string>& cursor, const boost::optional<std::int32_t>& limit, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/runs/{run_id}/episodes";
    std::map<std::string, std::string> headers;
    // Path parameters use their declared simple, label, or matrix style.
    replacePathParameter(path, "run_id", runId, "simple", false);
    // Query parameters preserve style, explode, allowReserved, and allowEmptyValue.
    std::stringstream queryParameterStream;
    const char* queryParameterSeparator = "?";
    if (cursor) {
        appendParamQueryParameter(
            queryParameterStream,
            queryParameterSeparator,
            "cursor",
            *cursor,
            "form",
            true,
            false,
            false);
    }
    if (limit) {
        appendParamQueryParameter(
            queryParameterStream,
            queryParameterSeparator,
            "limit",
            *limit,
            "form",
            true,
            false,
            false);
    }
    path += queryParameterStream.str();
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("listEpisodes", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<EpisodeList> deserializedResponse = std::make_shared<EpisodeList>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<EpisodeList>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<RunList>
ControlApi::listRuns(
    const boost::optional<std::string>& cursor, const boost::optional<std::int32_t>& limit, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/runs";
    std::map<std::string, std::string> headers;
    // Query parameters preserve style, explode, allowReserved, and allowEmptyValue.
    std::stringstream queryParameterStream;
    const char* queryParameterSeparator = "?";
    if (cursor) {
        appendParamQueryParameter(
            queryParameterStream,
            queryParameterSeparator,
            "cursor",
            *cursor,
            "form",
            true,
            false,
            false);
    }
    if (limit) {
        appendParamQueryParameter(
            queryParameterStream,
            queryParameterSeparator,
            "limit",
            *limit,
            "form",
            true,
            false,
            false);
    }
    path += queryParameterStream.str();
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("listRuns", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("GET",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<RunList> deserializedResponse = std::make_shared<RunList>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<RunList>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<Run>
ControlApi::submitRun(
    const std::shared_ptr<SubmitRun>& submitRun, const std::string& idempotencyKey, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/runs";
    std::map<std::string, std::string> headers;
    static const std::vector<std::string> contentTypes{ "application/json", };
    std::string requestContentType = selectPreferredContentType(contentTypes);
    headers["Content-Type"] = requestContentType;
    // Body params
    if (isJsonContentType(requestContentType)) {
        serializedRequestBody = boost::json::serialize(toRequestJsonValue(submitRun));
    } else {
        throw std::invalid_argument("Content type '" + requestContentType + "' does not support structured request bodies");
    }
    // headers
    headers.emplace("Idempotency-Key", serializeHeaderParameterValue(idempotencyKey, false));
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("submitRun", operationSecurity, path, headers);
    }
    // Link metadata preserved; no automatic traversal is generated: get
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("POST",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Run> deserializedResponse = std::make_shared<Run>();
    if (statusCode == boost::beast::http::status(201)) {
        ResponseBodyDeserializer<std::shared_ptr<Run>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<Run>
ControlApi::resumeRun(
    const std::string& runId, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/runs/{run_id}/resume";
    std::map<std::string, std::string> headers;
    // Path parameters use their declared simple, label, or matrix style.
    replacePathParameter(path, "run_id", runId, "simple", false);
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("resumeRun", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("POST",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Run> deserializedResponse = std::make_shared<Run>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<Run>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}

std::shared_ptr<Run>
ControlApi::stopRun(
    const std::string& runId, const std::shared_ptr<StopRun>& stopRun, const std::string& proctorVersion) {
    std::string serializedRequestBody;
    std::string path = operationServerPrefix(m_context, "http://127.0.0.1:8460") + "/v1/runs/{run_id}/stop";
    std::map<std::string, std::string> headers;
    static const std::vector<std::string> contentTypes{ "application/json", };
    std::string requestContentType = selectPreferredContentType(contentTypes);
    headers["Content-Type"] = requestContentType;
    // Body params
    if (isJsonContentType(requestContentType)) {
        serializedRequestBody = boost::json::serialize(toRequestJsonValue(stopRun));
    } else {
        throw std::invalid_argument("Content type '" + requestContentType + "' does not support structured request bodies");
    }
    // Path parameters use their declared simple, label, or matrix style.
    replacePathParameter(path, "run_id", runId, "simple", false);
    // headers
    headers.emplace("Proctor-Version", serializeHeaderParameterValue(proctorVersion, false));

    std::string responseContentType = "application/json";
    static const std::vector<std::string> acceptTypes{ "application/json","application/problem+json", };
    responseContentType = selectPreferredContentType(acceptTypes);
    headers["Accept"] = responseContentType;

    // Security alternatives are OR groups containing AND-required schemes.
    {
        static const std::vector<SecurityRequirementGroup> operationSecurity = {
            SecurityRequirementGroup{ {
                SecuritySchemeUse{"bearer", "http", "", "", "bearer", {}},
            } },
        };
        applyOperationSecurity("stopRun", operationSecurity, path, headers);
    }
    auto statusCode = boost::beast::http::status::unknown;
    std::string responseBody;
    try {
        std::tie(statusCode, responseBody) =
            m_client->execute("POST",
                              path,
                              serializedRequestBody,
                              headers);
    }
    catch(const std::exception& exception) {
        handleStdException(exception);
    }
    catch(...) {
        handleUncaughtException();
    }

    std::shared_ptr<Run> deserializedResponse = std::make_shared<Run>();
    if (statusCode == boost::beast::http::status(200)) {
        ResponseBodyDeserializer<std::shared_ptr<Run>>::deserialize(
            deserializedResponse,
            responseBody,
            responseContentType,
            false);
        return deserializedResponse;
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 4U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    if (static_cast<unsigned int>(statusCode) / 100U == 5U) {
        throw ControlApiException(statusCode, "Refused; `code` says why (see x-problems).", responseBody);
    }
    throw ControlApiException(statusCode, "Unexpected HTTP status code", responseBody);
}



std::string ControlApi::base64encode(const std::string& str) {
    return base64encodeImpl(str);
}

void ControlApi::setPreferredMediaTypeHeader(std::map<std::string, std::string>& headers, const std::string& headerName, const std::vector<std::string>& contentTypes) {
    const std::string contentType = selectPreferredContentType(contentTypes);
    headers[headerName] = contentType;
}

void ControlApi::handleStdException(const std::exception&) {
    throw;
}

void ControlApi::handleUncaughtException() {
    throw;
}


}  // namespace proctor
}  // namespace api
