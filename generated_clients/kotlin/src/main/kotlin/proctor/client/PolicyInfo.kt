/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class PolicyInfo(
    @SerialName("name") val name: String,
    @SerialName("version") val version: String? = null,
    @SerialName("submitter") val submitter: String? = null,
    @SerialName("homepage") val homepage: String? = null,
)
