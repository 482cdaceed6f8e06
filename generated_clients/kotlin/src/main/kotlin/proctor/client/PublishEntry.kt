/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

package proctor.client

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** What an entry says of itself; a member that is absent is not shown. */
@Serializable
data class PublishEntry(
    @SerialName("model_name") val modelName: String,
    /** Whether others see the entry, and whether it has a rank. */
    @SerialName("is_public") val isPublic: Boolean,
    /** What kind of model it is, for example `VLA` or `diffusion policy`. */
    @SerialName("model_type") val modelType: String? = null,
    @SerialName("organisation") val organisation: String? = null,
    @SerialName("homepage") val homepage: String? = null,
    @SerialName("code_url") val codeUrl: String? = null,
    @SerialName("notes") val notes: String? = null,
)
