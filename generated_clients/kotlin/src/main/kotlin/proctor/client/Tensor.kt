/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** C order, little-endian; a bool is one byte, 0 or 1. */
@Serializable
data class Tensor(
    @SerialName("dtype") val dtype: String,
    @SerialName("shape") val shape: List<Long>,
    /** Base64 with padding in JSON; `bin` in MessagePack. */
    @SerialName("data") val `data`: String,
)
