/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Benchmark.h
 *
 * Everything about a benchmark that can change a score.
 */

#ifndef PROCTOR_MODEL_Benchmark_MODEL_H_
#define PROCTOR_MODEL_Benchmark_MODEL_H_

#include "VectorSpace.h"
#include "ImageSize.h"
#include "SimulatorInfo.h"
#include "SuccessRule.h"
#include "ImageCodec.h"
#include <string>
#include "ObservationSpace.h"
#include <map>
#include <vector>
#include "AnyType.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
/// Everything about a benchmark that can change a score.
/// </summary>
class Benchmark
{
public:
    Benchmark() = default;
    explicit Benchmark(boost::json::value const& value);
    virtual ~Benchmark() = default;

    std::string toJsonString(bool prettyJson = false) const;
    void fromJsonString(std::string const& jsonString);
    boost::json::value toJsonValue() const;
    void fromJsonValue(boost::json::value const& value);
    using ExtraJsonProperties = std::map<std::string, boost::json::value>;

    ExtraJsonProperties const& getExtraJsonProperties() const noexcept
    {
        return m_extraJsonProperties;
    }

    void setExtraJsonProperties(ExtraJsonProperties extraJsonProperties)
    {
        m_extraJsonProperties = std::move(extraJsonProperties);
    }

    /////////////////////////////////////////////
    /// Benchmark members

    /// <summary>
    ///
    /// </summary>
    std::string getBenchmarkId() const;
    void setBenchmarkId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getVersion() const;
    void setVersion(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getTitle() const;
    void setTitle(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getDescription() const;
    void setDescription(std::string value);

    /// <summary>
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    /// </summary>
    std::string getManifestSha256() const;
    void setManifestSha256(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getEpisodesTotal() const;
    void setEpisodesTotal(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::vector<std::string> getTasks() const;
    void setTasks(std::vector<std::string> value);

    /// <summary>
    ///
    /// </summary>
    std::vector<std::string> getSplits() const;
    void setSplits(std::vector<std::string> value);

    /// <summary>
    /// Actions per simulated second.
    /// </summary>
    double getControlRateHz() const;
    void setControlRateHz(double value);

    /// <summary>
    /// Steps after which an episode is truncated.
    /// </summary>
    std::int32_t getMaxSteps() const;
    void setMaxSteps(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getMaxChunk() const;
    void setMaxChunk(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getMaxAttempts() const;
    void setMaxAttempts(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getMaxFaults() const;
    void setMaxFaults(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    SuccessRule getSuccessRule() const;
    void setSuccessRule(SuccessRule value);

    /// <summary>
    /// Name of an action value \342\206\222 what it means.
    /// </summary>
    std::map<std::string, VectorSpace> getActionSpace() const;
    void setActionSpace(std::map<std::string, VectorSpace> value);

    /// <summary>
    ///
    /// </summary>
    ObservationSpace getObservationSpace() const;
    void setObservationSpace(ObservationSpace value);

    /// <summary>
    /// Sizes that may be chosen at submit; the first is the default.
    /// </summary>
    std::vector<ImageSize> getImageSizes() const;
    void setImageSizes(std::vector<ImageSize> value);

    /// <summary>
    /// Codecs that may be chosen at submit; the first is the default.
    /// </summary>
    std::vector<ImageCodec> getImageCodecs() const;
    void setImageCodecs(std::vector<ImageCodec> value);

    /// <summary>
    ///
    /// </summary>
    SimulatorInfo getSimulator() const;
    void setSimulator(SimulatorInfo value);

    /// <summary>
    /// Why a run cannot be submitted here now, and the cure; null when it can.
    /// </summary>
    std::optional<std::string> getUnavailableReason() const;
    void setUnavailableReason(std::optional<std::string> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Benchmark_id = "";
    std::string m_Version = "";
    std::string m_Title = "";
    std::string m_Description = "";
    std::string m_Manifest_sha256 = "";
    std::int32_t m_Episodes_total = 0;
    std::vector<std::string> m_Tasks;
    std::vector<std::string> m_Splits;
    double m_Control_rate_hz = 0.0;
    std::int32_t m_Max_steps = 0;
    std::int32_t m_Max_chunk = 0;
    std::int32_t m_Max_attempts = 0;
    std::int32_t m_Max_faults = 0;
    SuccessRule m_Success_rule;
    std::map<std::string, VectorSpace> m_Action_space;
    ObservationSpace m_Observation_space;
    std::vector<ImageSize> m_Image_sizes;
    std::vector<ImageCodec> m_Image_codecs;
    SimulatorInfo m_Simulator;
    std::optional<std::string> m_Unavailable_reason;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Benchmark>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Benchmark>>& vec, const std::string& json);

Benchmark fromJsonValue_Benchmark(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Benchmark_MODEL_H_ */
