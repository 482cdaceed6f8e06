/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Recorded with the result, because it changes the score. */
@Serializable
data class ImageChoice(
    @SerialName("codec") val codec: String,
    @SerialName("width") val width: Int,
    @SerialName("height") val height: Int,
)
