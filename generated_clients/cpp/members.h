/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/* How the members of a message are read from JSON and written to it.
 *
 * A message lists its members once, in `visit`. A required member that is missing is an
 * error; an optional one that is missing or null is std::nullopt; a member that a later
 * version of the protocol added is passed over.
 */
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace proctor {

class MemberReader {
public:
    explicit MemberReader(nlohmann::json const& object) : m_object(object) {
        if (!object.is_object()) throw std::invalid_argument("a message is no JSON object");
    }

    template <typename T> void required(char const* name, T& member) const {
        auto const at = m_object.find(name);
        if (at == m_object.end()) throw std::invalid_argument(std::string("member ") + name + " is missing");
        at->get_to(member);
    }

    template <typename T> void required(char const* name, std::optional<T>& member) const {
        if (!m_object.contains(name)) throw std::invalid_argument(std::string("member ") + name + " is missing");
        optional(name, member);
    }

    template <typename T> void optional(char const* name, std::optional<T>& member) const {
        auto const at = m_object.find(name);
        if (at == m_object.end() || at->is_null()) member.reset();
        else at->get_to(member.emplace());
    }

private:
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

template <typename Message, typename = typename Message::IsMessage>
void from_json(nlohmann::json const& object, Message& message) {
    MemberReader reader(object);
    Message::visit(message, reader);
}

template <typename Message, typename = typename Message::IsMessage>
void to_json(nlohmann::json& object, Message const& message) {
    MemberWriter writer(object);
    Message::visit(message, writer);
}

} // namespace proctor
