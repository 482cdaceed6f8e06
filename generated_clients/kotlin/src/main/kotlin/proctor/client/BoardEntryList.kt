/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class BoardEntryList(
    @SerialName("entries") val entries: List<BoardEntry>,
    @SerialName("next_cursor") val nextCursor: String?,
)
