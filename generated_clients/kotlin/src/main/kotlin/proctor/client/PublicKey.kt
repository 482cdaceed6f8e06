/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class PublicKey(
    /** `SHA256:` and the SHA-256 of the key in hexadecimal digits. */
    @SerialName("keyid") val keyid: String,
    /** `ed25519`, or another one of a later version. */
    @SerialName("algorithm") val algorithm: String,
    /** Its 32 bytes. */
    @SerialName("public_key") val publicKey: String,
    @SerialName("created_at") val createdAt: String,
    /** When it signed for the last time; null for the key in use. */
    @SerialName("retired_at") val retiredAt: String?,
)
