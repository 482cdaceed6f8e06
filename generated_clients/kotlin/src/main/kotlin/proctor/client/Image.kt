/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** RGB or grey, row 0 on top; raw is height × width × channels bytes. */
@Serializable
data class Image(
    @SerialName("codec") val codec: String,
    @SerialName("width") val width: Int,
    @SerialName("height") val height: Int,
    @SerialName("channels") val channels: Int,
    /** Base64 with padding in JSON; `bin` in MessagePack. */
    @SerialName("data") val `data`: String,
)
