/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** `proctor` is policy.yaml. `openai_chat` asks for a chat completion at `chat/completions` below the URL, for benchmarks that are answered in words. `openai_completions` asks for the completion of a text at `completions` below the URL, for such benchmarks without images. */
@Serializable
enum class PolicyProtocol {
    @SerialName("proctor") PROCTOR,
    @SerialName("openai_chat") OPENAI_CHAT,
    @SerialName("openai_completions") OPENAI_COMPLETIONS,
}
