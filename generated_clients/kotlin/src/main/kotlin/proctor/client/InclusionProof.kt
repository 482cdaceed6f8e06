/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class InclusionProof(
    @SerialName("leaf_index") val leafIndex: Long,
    @SerialName("tree_size") val treeSize: Long,
    @SerialName("hashes") val hashes: List<String>,
)
