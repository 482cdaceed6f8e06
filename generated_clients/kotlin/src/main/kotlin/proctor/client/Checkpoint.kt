/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class Checkpoint(
    @SerialName("tree_size") val treeSize: Long,
    /** The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software. */
    @SerialName("root_sha256") val rootSha256: String,
    /** The signed note, which says both as well. */
    @SerialName("note") val note: String,
    /** Of the key of `list_keys` that signed it. */
    @SerialName("keyid") val keyid: String,
)
