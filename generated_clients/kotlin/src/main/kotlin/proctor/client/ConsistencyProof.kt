/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class ConsistencyProof(
    @SerialName("old_size") val oldSize: Long,
    @SerialName("new_size") val newSize: Long,
    @SerialName("hashes") val hashes: List<String>,
)
