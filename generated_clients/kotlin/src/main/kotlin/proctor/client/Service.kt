/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** What a server says of itself before anyone authenticates. */
@Serializable
data class Service(
    @SerialName("name") val name: String,
    /** Version of the server software. */
    @SerialName("version") val version: String,
    @SerialName("protocol") val protocol: ProtocolRange,
    /** Parts of the protocol offered; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these. */
    @SerialName("profiles") val profiles: List<String>,
    @SerialName("limits") val limits: Limits,
    /** Media types of the data plane. */
    @SerialName("encodings") val encodings: List<String>,
    @SerialName("image_codecs") val imageCodecs: List<String>,
    /** The server's clock, UTC. */
    @SerialName("server_time") val serverTime: String,
)
