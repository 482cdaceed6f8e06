/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import java.io.IOException
import java.net.URI
import java.net.URLEncoder
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.time.Duration
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json

/** Reads and writes messages. A member that a later version of the protocol added is passed over. */
val json = Json { ignoreUnknownKeys = true }

/** Why a call has no result. */
sealed class ProctorException(message: String, cause: Throwable? = null) : IOException(message, cause)

/** No answer came. What was sent may have had its effect. */
class ConnectionError(message: String, cause: Throwable? = null) : ProctorException(message, cause)

/** A success that is not the message expected. What was sent may have had its effect. */
class InvalidAnswer(message: String, cause: Throwable? = null) : ProctorException(message, cause)

/** An answer that is no success. `problem.code` may be one of a later version; [retryAfterS] is that of the answer. */
class Refused(val status: Int, val problem: Problem, val retryAfterS: Double?) :
    ProctorException("${problem.detail} [${problem.code}]")

/** A request; [path] is a template until its parameters are put in. */
class Request(val method: String, var path: String) {
    var query = ""
    var body: String? = null
    val headers = mutableMapOf<String, String>()

    fun path(name: String, value: Any) {
        path = path.replace("{$name}", escaped(value))
    }

    fun query(name: String, value: Any?) {
        if (value != null) query += (if (query.isEmpty()) "?" else "&") + name + "=" + escaped(value)
    }

    fun header(name: String, value: Any?) {
        if (value != null) headers[name] = value.toString()
    }

    private fun escaped(value: Any) = URLEncoder.encode(value.toString(), Charsets.UTF_8).replace("+", "%20")
}

/** A server, and who asks it. Any number of threads may use it; connections stay open between requests. */
class Connection(url: String, private val token: String, private val timeout: Duration = Duration.ofSeconds(60)) {
    private val url = url.trimEnd('/')
    private val client = HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).connectTimeout(timeout).build()

    /** The message that answers. Throws [ProctorException]. */
    inline fun <reified Message> receive(request: Request): Message {
        val answer = send(request)
        try {
            return json.decodeFromString(answer)
        } catch (error: SerializationException) {
            val why = error.message.orEmpty().lineSequence().first()
            throw InvalidAnswer("${request.method} ${request.path} was answered by no ${Message::class.simpleName}: $why", error)
        }
    }

    /** The text of a success. Throws [ConnectionError] and [Refused]. */
    fun send(request: Request): String {
        val answer = exchange(request)
        if (answer.statusCode() in 200..299) return answer.body()
        val retryAfterS = answer.headers().firstValue("Retry-After").orElse("").toDoubleOrNull()
        throw Refused(answer.statusCode(), problemOf(answer), retryAfterS)
    }

    private fun exchange(request: Request): HttpResponse<String> {
        val body = request.body?.let(HttpRequest.BodyPublishers::ofString) ?: HttpRequest.BodyPublishers.noBody()
        val sent = HttpRequest.newBuilder(URI(url + request.path + request.query)).method(request.method, body)
            .header("Accept", "application/json, application/problem+json").header("Authorization", "Bearer $token")
        if (request.body != null) sent.header("Content-Type", "application/json")
        request.headers.forEach { (name, value) -> sent.header(name, value) }
        val answer = client.sendAsync(sent.build(), HttpResponse.BodyHandlers.ofString())
        try {
            return answer.get(timeout.toMillis(), TimeUnit.MILLISECONDS) // a request's own timeout ends with the headers
        } catch (error: ExecutionException) {
            throw ConnectionError("no answer from $url: ${error.cause}", error.cause)
        } catch (error: TimeoutException) {
            throw ConnectionError("no answer from $url within ${timeout.toMillis() / 1000.0} s", error)
        } finally {
            answer.cancel(true)
        }
    }

    /** A gateway's answer is no Problem: then its status is all that is known. */
    private fun problemOf(answer: HttpResponse<String>): Problem = try {
        json.decodeFromString(answer.body())
    } catch (_: SerializationException) {
        val status = answer.statusCode()
        Problem(
            type = "about:blank", title = "", status = status, code = "bad_answer",
            detail = "HTTP status $status without a problem",
            retryable = status == 429 || status >= 500, sideEffects = SideEffects.POSSIBLE,
        )
    }
}
