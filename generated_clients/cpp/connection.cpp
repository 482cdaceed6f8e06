/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#include "connection.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include <curl/curl.h>

namespace proctor {
namespace {

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
Problem problem_of(long status, std::string const& answer) try {
    return nlohmann::json::parse(answer).get<Problem>();
} catch (std::exception const&) {
    Problem unknown;
    unknown.status = static_cast<std::int32_t>(status);
    unknown.code = "bad_answer";
    unknown.detail = "HTTP status " + std::to_string(status) + " without a problem";
    unknown.retryable = status == 429 || status >= 500;
    unknown.side_effects = "possible";
    return unknown;
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
    : m_url(std::move(url)), m_token(std::move(token)), m_curl(curl_easy_init(), curl_easy_cleanup) {
    if (!m_curl) throw ConnectionError("libcurl cannot be used");
    while (!m_url.empty() && m_url.back() == '/') m_url.pop_back();
    curl_easy_setopt(m_curl.get(), CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(m_curl.get(), CURLOPT_TIMEOUT_MS, static_cast<long>(timeout_s * 1000));
}

std::string Connection::send(Request const& request) {
    CURL* const curl = m_curl.get();
    std::string const url = m_url + request.path + request.query;
    std::string answer;
    double retry_after_s = 0;
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
    std::string const sent = request.body.value_or("");
    if (request.body || request.method == "POST") {
        curl_easy_setopt(curl, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(sent.size()));
        curl_easy_setopt(curl, CURLOPT_POSTFIELDS, sent.c_str());
    } else {
        curl_easy_setopt(curl, CURLOPT_HTTPGET, 1L);
    }
    curl_easy_setopt(curl, CURLOPT_CUSTOMREQUEST, request.method.c_str()); // after what else sets a method
    CURLcode const result = curl_easy_perform(curl);
    if (result != CURLE_OK) throw ConnectionError(curl_easy_strerror(result));
    long status = 0;
    curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
    if (status < 200 || status > 299) throw Refused(status, problem_of(status, answer), retry_after_s);
    return answer;
}

} // namespace proctor
