/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** Who plays, by its own words; for the profile `attribution`. */
@Serializable
data class Player(
    /** Of the policy, as in `policy` of the run. */
    @SerialName("name") val name: String,
    /** Of the policy. */
    @SerialName("version") val version: String? = null,
    /** The program that attaches and its version. */
    @SerialName("client") val client: String? = null,
)
