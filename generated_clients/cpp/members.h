/* Written by hand, beside what is generated from the specification. */

/* How the members of a message are read from JSON and written to it.
 *
 * A message lists its members once, in `visit`. A required member that is missing is an
 * error, as is a value of another type than the member's; an optional one that is missing
 * or null is std::nullopt; a member that a later version of the protocol added is passed over.
 */
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <nlohmann/json.hpp>

namespace proctor {

/// What is read is not the message that it should be.
struct InvalidMessage : std::runtime_error {
    /// place: of the value, such as `/lease/expires_at`; empty for the whole message. fault: `is missing`.
    InvalidMessage(std::string const& place, std::string const& fault)
        : std::runtime_error((place.empty() ? "it" : place) + " " + fault), place(place), fault(fault) {}

    /// The same, seen from the message or list that holds the value under this name.
    InvalidMessage within(std::string const& name) const { return {"/" + name + place, fault}; }

    std::string place, fault;
};

class MemberReader {
public:
    explicit MemberReader(nlohmann::json const& object) : m_object(object) { expect(object.is_object(), "is no object"); }

    template <typename T> void required(char const* name, T& member) const {
        read_at(name, present(name), member);
    }

    template <typename T> void required(char const* name, std::optional<T>& member) const {
        present(name);
        optional(name, member);
    }

    template <typename T> void optional(char const* name, std::optional<T>& member) const {
        auto const at = m_object.find(name);
        if (at == m_object.end() || at->is_null()) member.reset();
        else read_at(name, *at, member.emplace());
    }

private:
    static void expect(bool is_so, char const* fault) {
        if (!is_so) throw InvalidMessage("", fault);
    }

    nlohmann::json const& present(char const* name) const {
        auto const at = m_object.find(name);
        if (at == m_object.end()) throw InvalidMessage(std::string("/") + name, "is missing");
        return *at;
    }

    template <typename T> static void read_at(std::string const& name, nlohmann::json const& value, T& member) try {
        read(value, member);
    } catch (InvalidMessage const& error) {
        throw error.within(name);
    }

    template <typename T> static void read(nlohmann::json const& value, T& member) {
        // The library would read true as 1, and 1.5 as 1.
        if constexpr (std::is_same_v<T, bool>) expect(value.is_boolean(), "is neither true nor false");
        else if constexpr (std::is_integral_v<T>) expect(is_whole<T>(value), "is no whole number, or too large");
        else if constexpr (std::is_floating_point_v<T>) expect(value.is_number(), "is no number");
        else if constexpr (std::is_same_v<T, std::string>) expect(value.is_string(), "is no text");
        value.get_to(member);
    }

    template <typename T> static void read(nlohmann::json const& value, std::vector<T>& items) {
        expect(value.is_array(), "is no list");
        items = std::vector<T>(value.size());
        std::size_t i = 0;
        try {
            for (; i < items.size(); ++i) read(value[i], items[i]);
        } catch (InvalidMessage const& error) {
            throw error.within(std::to_string(i));
        }
    }

    template <typename T> static void read(nlohmann::json const& value, std::map<std::string, T>& entries) {
        expect(value.is_object(), "is no object");
        entries.clear();
        for (auto const& [name, entry] : value.items()) read_at(name, entry, entries[name]);
    }

    template <typename T> static bool is_whole(nlohmann::json const& value) {
        constexpr auto least = std::numeric_limits<T>::min(), most = std::numeric_limits<T>::max();
        if (value.is_number_unsigned()) return value.get<std::uint64_t>() <= static_cast<std::uint64_t>(most);
        if (value.is_number_integer()) return value.get<std::int64_t>() >= least && value.get<std::int64_t>() <= most;
        if (!value.is_number_float()) return false;
        // 3.0 is a whole number too; above 2^53 a double is not exact.
        double const number = value.get<double>(), bound = std::ldexp(1, std::min(std::numeric_limits<T>::digits, 53));
        return std::trunc(number) == number && std::abs(number) < bound;
    }

    nlohmann::json const& m_object;
};

class MemberWriter {
public:
    explicit MemberWriter(nlohmann::json& object) : m_object(object) { object = nlohmann::json::object(); }

    template <typename T> void required(char const* name, T const& member) const { m_object[name] = member; }

    template <typename T> void required(char const* name, std::optional<T> const& member) const {
        if (member) m_object[name] = *member;
        else m_object[name] = nullptr;
    }

    template <typename T> void optional(char const* name, std::optional<T> const& member) const {
        if (member) m_object[name] = *member;
    }

private:
    nlohmann::json& m_object;
};

/// Throws InvalidMessage.
template <typename Message, typename = decltype(Message::schema_name)>
void from_json(nlohmann::json const& object, Message& message) {
    MemberReader reader(object);
    Message::visit(message, reader);
}

template <typename Message, typename = decltype(Message::schema_name)>
void to_json(nlohmann::json& object, Message const& message) {
    MemberWriter writer(object);
    Message::visit(message, writer);
}

} // namespace proctor
