/* Written by hand, beside what is generated from the specification. */

#include "connection.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include <curl/curl.h>

namespace proctor {
namespace {

constexpr int redirects_max = 5;

std::string escaped(std::string const& text) {
    std::unique_ptr<char, decltype(&curl_free)> const made(curl_easy_escape(nullptr, text.data(), static_cast<int>(text.size())), curl_free);
    return made.get();
}

std::size_t append(char* data, std::size_t size, std::size_t count, void* target) {
    static_cast<std::string*>(target)->append(data, size * count);
    return size * count;
}

std::size_t read_header(char* data, std::size_t size, std::size_t count, void* retry_after_s) {
    std::string line(data, size * count);
    std::transform(line.begin(), line.end(), line.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::string const name = "retry-after:";
    if (line.rfind(name, 0) == 0) *static_cast<double*>(retry_after_s) = std::atof(line.c_str() + name.size());
    return size * count;
}

/// A gateway's answer is no Problem: then its status is all that is known.
Problem problem_of(long status, std::string const& answer, std::string const& url) try {
    return nlohmann::json::parse(answer).get<Problem>();
} catch (std::exception const&) {
    Problem unknown;
    unknown.status = static_cast<std::int32_t>(status);
    unknown.code = "bad_answer";
    unknown.detail = url + " answered HTTP status " + std::to_string(status) + " without a problem.";
    unknown.retryable = status == 429 || status >= 500;
    unknown.side_effects = "possible";
    return unknown;
}

/// The part of a URL that names the server.
std::string origin_of(std::string const& url) { return url.substr(0, url.find('/', url.find("//") + 2)); }

/// Which variable names the proxy that libcurl used, if there is one.
std::string proxy_note(std::string const& url) {
    auto const names = url.rfind("https:", 0) == 0 ? std::array{"https_proxy", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"}
                                                   : std::array{"http_proxy", "http_proxy", "all_proxy", "ALL_PROXY"};
    for (auto const name : names)
        if (auto const value = std::getenv(name); !is_this_machine(url) && value && *value)
            return std::string("; ") + name + " names a proxy, and hosts in NO_PROXY are reached without it";
    return "";
}

/// What to change in the base URL, if that is wrong.
std::string hint_of(long status, std::string const& base, std::string const& target, std::string const& place) {
    if (!place.empty()) {
        auto const rest = place.size() - std::min(place.size(), target.size());
        return " The server has moved to " + (place.substr(rest) == target ? place.substr(0, rest) : place) + ": give that as the base URL.";
    }
    std::string const version = "/v1";
    if (status != 404 || base.size() < version.size() || base.substr(base.size() - version.size()) != version) return "";
    return " The base URL ends with /v1, which every request adds: give " + base.substr(0, base.size() - version.size()) + ".";
}

} // namespace

void Request::path_parameter(std::string const& name, std::string const& value) {
    auto const place = path.find("{" + name + "}");
    path.replace(place, name.size() + 2, escaped(value));
}

void Request::query_parameter(std::string const& name, std::string const& value) {
    query += (query.empty() ? "?" : "&") + name + "=" + escaped(value);
}

void Request::query_parameter(std::string const& name, std::optional<std::string> const& value) {
    if (value) query_parameter(name, *value);
}

void Request::query_parameter(std::string const& name, std::optional<std::int32_t> const& value) {
    if (value) query_parameter(name, std::to_string(*value));
}

void Request::query_parameter(std::string const& name, std::optional<double> const& value) {
    if (value) query_parameter(name, nlohmann::json(*value).dump());
}

void Request::header(std::string const& name, std::optional<std::string> const& value) {
    if (value) headers.emplace_back(name, *value);
}

Connection::Connection(std::string url, std::string token, double timeout_s)
    : m_url(clean_base_url(url)), m_token(clean_token(token)), m_curl(curl_easy_init(), curl_easy_cleanup) {
    if (!m_curl) throw ConnectionError("libcurl cannot be used");
    if (is_this_machine(m_url)) curl_easy_setopt(m_curl.get(), CURLOPT_PROXY, ""); // whatever the environment names
    curl_easy_setopt(m_curl.get(), CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(m_curl.get(), CURLOPT_TIMEOUT_MS, static_cast<long>(timeout_s * 1000));
}

std::string Connection::send(Request const& request) {
    std::string const target = request.path + request.query;
    std::string url = m_url + target;
    for (int left = redirects_max;; --left) {
        long status = 0;
        std::string place;
        double retry_after_s = 0;
        auto const answer = perform(url, request, status, place, retry_after_s);
        if (status >= 200 && status <= 299) return answer;
        if (request.method == "GET" && left > 0 && !place.empty() && origin_of(place) == origin_of(url)) {
            url = place;
            continue;
        }
        auto why = problem_of(status, answer, url);
        why.detail += hint_of(status, m_url, target, place);
        throw Refused(status, why, retry_after_s);
    }
}

/// Send a request once. place: where the answer redirects to, or empty.
std::string Connection::perform(std::string const& url, Request const& request, long& status, std::string& place, double& retry_after_s) {
    CURL* const curl = m_curl.get();
    std::string answer;
    char reason[CURL_ERROR_SIZE] = "";
    curl_slist* lines = curl_slist_append(nullptr, "Accept: application/json, application/problem+json");
    lines = curl_slist_append(lines, ("Authorization: Bearer " + m_token).c_str());
    lines = curl_slist_append(lines, "Expect:"); // long bodies are sent at once
    if (request.body) lines = curl_slist_append(lines, "Content-Type: application/json");
    for (auto const& [name, value] : request.headers) lines = curl_slist_append(lines, (name + ": " + value).c_str());
    std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> const headers(lines, curl_slist_free_all);
    curl_easy_setopt(curl, CURLOPT_URL, url.c_str());
    curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
    curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, append);
    curl_easy_setopt(curl, CURLOPT_WRITEDATA, &answer);
    curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, read_header);
    curl_easy_setopt(curl, CURLOPT_HEADERDATA, &retry_after_s);
    curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, reason);
    std::string const sent = request.body.value_or("");
    if (request.body || request.method == "POST") {
        curl_easy_setopt(curl, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(sent.size()));
        curl_easy_setopt(curl, CURLOPT_POSTFIELDS, sent.c_str());
    } else {
        curl_easy_setopt(curl, CURLOPT_HTTPGET, 1L);
    }
    curl_easy_setopt(curl, CURLOPT_CUSTOMREQUEST, request.method.c_str()); // after what else sets a method
    CURLcode const result = curl_easy_perform(curl);
    curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, nullptr);
    if (result != CURLE_OK) throw ConnectionError((*reason ? reason : curl_easy_strerror(result)) + proxy_note(url));
    curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
    char* moved = nullptr;
    curl_easy_getinfo(curl, CURLINFO_REDIRECT_URL, &moved);
    if (moved) place = moved;
    return answer;
}

} // namespace proctor
