/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** The `player` of an `attach_worker`. */
@Serializable
data class PlayerView(
    @SerialName("name") val name: String,
    @SerialName("version") val version: String? = null,
    @SerialName("client") val client: String? = null,
)
