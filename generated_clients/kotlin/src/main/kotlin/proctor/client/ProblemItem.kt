/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

@Serializable
data class ProblemItem(
    /** JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record. */
    @SerialName("pointer") val pointer: String,
    @SerialName("detail") val detail: String,
)
