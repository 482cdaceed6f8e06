/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class HistoryLeaf(
    @SerialName("index") val index: Long,
    /** A JSON text, whose UTF-8 is what the tree has; board.md has its members. */
    @SerialName("leaf") val leaf: String,
)
