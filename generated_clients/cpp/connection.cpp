/* Written by hand, beside what is generated from the specification. */

#include "connection.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <mutex>
#include <set>

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

std::size_t read_header(char* data, std::size_t size, std::size_t count, void* target) {
    auto& answer = *static_cast<Answer*>(target);
    std::string line(data, size * count);
    std::transform(line.begin(), line.end(), line.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    auto const is = [&](std::string const& name) { return line.rfind(name + ":", 0) == 0; };
    if (is("retry-after")) answer.retry_after_s = std::atof(line.c_str() + line.find(':') + 1);
    if (is("content-type")) answer.is_page = line.find("text/html") != std::string::npos;
    if (is("proctor-version")) answer.is_of_proctor = true;
    if (line.rfind("http/", 0) == 0) answer.has_whole_head = answer.has_length = false; // after an interim answer, too
    if (is("content-length") || is("transfer-encoding")) answer.has_length = true;
    if (line == "\r\n" || line == "\n") answer.has_whole_head = true;
    return size * count;
}

/// The part of a URL that names the server, without a user.
std::string origin_of(std::string const& url) {
    auto const start = url.find("//") == std::string::npos ? 0 : url.find("//") + 2;
    auto const end = url.find_first_of("/?#", start);
    auto const place = url.substr(start, end == std::string::npos ? end : end - start);
    return url.substr(0, start) + place.substr(place.rfind('@') + 1);
}

/// Whether an answer may soon be gone that is no message and no problem: the fault of a gateway, or, where a server
/// of Proctor has answered this program before, a page that is not the server's.
bool may_pass(Answer const& answer, std::string const& url) {
    static std::mutex mutex;
    static std::set<std::string> known; // where a server of Proctor has answered
    static std::set<long> const unpassable{400, 405, 411, 413, 414, 415, 416, 417, 421, 426, 431, 501, 505};
    std::lock_guard const lock(mutex);
    if (answer.is_of_proctor) known.insert(origin_of(url));
    if (unpassable.count(answer.status) || (answer.status < 300 && !answer.is_page)) return false;
    return answer.status == 429 || answer.status >= 500 || (!answer.is_of_proctor && known.count(origin_of(url)));
}

/// Of an answer that is no Problem its status is all that is known.
Problem problem_of(Answer const& answer, std::string const& who) try {
    return nlohmann::json::parse(answer.text).get<Problem>();
} catch (std::exception const&) {
    Problem unknown;
    unknown.status = static_cast<std::int32_t>(answer.status);
    unknown.code = "bad_answer";
    unknown.detail = who + " answered HTTP status " + std::to_string(answer.status) + " without a problem.";
    if (!answer.is_of_proctor)
        unknown.detail += " Check that the URL is that of a Proctor server; a network that wants a sign-in in a browser answers so, too.";
    unknown.retryable = answer.may_pass;
    unknown.side_effects = "possible";
    return unknown;
}

/// The variable that names the proxy which libcurl uses, if there is one, and its value.
std::pair<std::string, std::string> proxy_of(std::string const& url) {
    auto const names = url.rfind("https:", 0) == 0 ? std::array{"https_proxy", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"}
                                                   : std::array{"http_proxy", "http_proxy", "all_proxy", "ALL_PROXY"};
    for (auto const name : names)
        if (auto const value = std::getenv(name); !is_this_machine(url) && value && *value) return {name, value};
    return {};
}

std::string proxy_note(std::string const& url) {
    auto const name = proxy_of(url).first;
    return name.empty() ? "" : "; " + name + " names a proxy, and hosts in NO_PROXY are reached without it";
}

/// What to change in the base URL, if that is wrong.
std::string hint_of(long status, std::string const& base, std::string const& target, std::string const& place) {
    if (!place.empty()) {
        auto const rest = place.size() - std::min(place.size(), target.size());
        if (place.substr(rest) != target) return " It redirects to " + origin_of(place) + ".";
        auto const path = place.substr(0, rest).find('/', place.find("//") + 2);
        return " The server has moved to " + origin_of(place) + (path < rest ? place.substr(path, rest - path) : "") + ": give that as the base URL.";
    }
    std::string const version = "/v1";
    if (status != 404 || base.size() < version.size() || base.substr(base.size() - version.size()) != version) return "";
    return " The base URL ends with /v1, which every request adds: give " + base.substr(0, base.size() - version.size()) + ".";
}

/// The words of libcurl, but for a server that is sent TLS and answers in another way, as one of http:// does.
std::string described(CURLcode result, std::string const& reason) {
    bool const is_plain = reason.find("wrong version number") != std::string::npos
        || reason.find("packet length too long") != std::string::npos
        || reason.find("unexpected TLS packet") != std::string::npos;
    if (is_plain) return "it does not speak TLS there: check the port, and whether the URL begins with http:// instead";
    return reason.empty() ? curl_easy_strerror(result) : reason;
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

Connection::Connection(std::string url, std::string token, double timeout_s, double silence_s)
    : m_url(clean_base_url(url)), m_token(clean_token(token)), m_curl(curl_easy_init(), curl_easy_cleanup) {
    if (!m_curl) throw ConnectionError("libcurl cannot be used");
    if (is_this_machine(m_url)) curl_easy_setopt(m_curl.get(), CURLOPT_PROXY, ""); // whatever the environment names
    curl_easy_setopt(m_curl.get(), CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(m_curl.get(), CURLOPT_TIMEOUT_MS, static_cast<long>(timeout_s * 1000));
    curl_easy_setopt(m_curl.get(), CURLOPT_LOW_SPEED_LIMIT, 1L);
    curl_easy_setopt(m_curl.get(), CURLOPT_LOW_SPEED_TIME, std::max(1L, static_cast<long>(silence_s)));
    curl_easy_setopt(m_curl.get(), CURLOPT_MAXCONNECTS, 1L);
}

std::string Connection::who_answered() const {
    auto const proxy = proxy_of(m_url).second;
    if (proxy.empty() || m_url.rfind("https:", 0) == 0) return m_url; // nothing changes what a tunnel has
    return m_url + ", or the proxy " + origin_of(proxy) + " in its place,";
}

Answer Connection::answer_to(Request const& request) {
    std::string const target = request.path + request.query;
    std::string url = m_url + target;
    for (int left = redirects_max;; --left) {
        auto const answer = perform(url, request);
        if (answer.status >= 200 && answer.status <= 299) return answer;
        if (request.method == "GET" && left > 0 && !answer.place.empty() && origin_of(answer.place) == origin_of(url)) {
            url = answer.place;
            continue;
        }
        auto why = problem_of(answer, who_answered());
        why.detail += hint_of(answer.status, m_url, target, answer.place);
        throw Refused(answer.status, why, answer.retry_after_s);
    }
}

/// Send a request once.
Answer Connection::perform(std::string const& url, Request const& request) {
    CURL* const curl = m_curl.get();
    Answer answer;
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
    curl_easy_setopt(curl, CURLOPT_WRITEDATA, &answer.text);
    curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, read_header);
    curl_easy_setopt(curl, CURLOPT_HEADERDATA, &answer);
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
    if (result != CURLE_OK) throw ConnectionError(described(result, reason) + proxy_note(url));
    // libcurl takes the end of the connection for that of a head.
    if (!answer.has_whole_head) throw ConnectionError("the connection ended before the head of the answer was whole" + proxy_note(url));
    curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &answer.status);
    char* moved = nullptr;
    curl_easy_getinfo(curl, CURLINFO_REDIRECT_URL, &moved);
    if (moved) answer.place = moved;
    answer.may_pass = may_pass(answer, url);
    // Another connection may lead to the server.
    curl_easy_setopt(curl, CURLOPT_FRESH_CONNECT, answer.is_of_proctor ? 0L : 1L);
    return answer;
}

} // namespace proctor
