/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Lease(
    @SerialName("expires_at") val expiresAt: String,
    @SerialName("idle_timeout_s") val idleTimeoutS: Double,
)
