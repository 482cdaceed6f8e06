/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class ImageSpace(
    @SerialName("channels") val channels: Int,
    @SerialName("description") val description: String,
    @SerialName("tasks") val tasks: List<String>? = null,
)
