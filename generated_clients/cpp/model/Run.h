/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Run.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Run_MODEL_H_
#define PROCTOR_MODEL_Run_MODEL_H_

#include "RunMode.h"
#include <string>
#include "RunState.h"
#include "PolicyServerView.h"
#include "Progress.h"
#include <map>
#include "PolicyInfo.h"
#include <vector>
#include "AnyType.h"
#include "ImageChoice.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class Run
{
public:
    Run() = default;
    explicit Run(boost::json::value const& value);
    virtual ~Run() = default;

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
    /// Run members

    /// <summary>
    ///
    /// </summary>
    std::string getRunId() const;
    void setRunId(std::string value);

    /// <summary>
    ///
    /// </summary>
    RunState getState() const;
    void setState(RunState value);

    /// <summary>
    /// Why the run is in this state, for people; never null when failed.
    /// </summary>
    std::optional<std::string> getReason() const;
    void setReason(std::optional<std::string> value);

    /// <summary>
    /// Whether a failed run may be resumed; null in other states.
    /// </summary>
    std::optional<bool> isRetryable() const;
    void setRetryable(std::optional<bool> value);

    /// <summary>
    ///
    /// </summary>
    std::string getBenchmarkId() const;
    void setBenchmarkId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getBenchmarkVersion() const;
    void setBenchmarkVersion(std::string value);

    /// <summary>
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    /// </summary>
    std::string getManifestSha256() const;
    void setManifestSha256(std::string value);

    /// <summary>
    ///
    /// </summary>
    PolicyInfo getPolicy() const;
    void setPolicy(PolicyInfo value);

    /// <summary>
    ///
    /// </summary>
    RunMode getMode() const;
    void setMode(RunMode value);

    /// <summary>
    ///
    /// </summary>
    PolicyServerView getPolicyServer() const;
    void setPolicyServer(PolicyServerView value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getMaxWorkers() const;
    void setMaxWorkers(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    double getIdleTimeoutS() const;
    void setIdleTimeoutS(double value);

    /// <summary>
    ///
    /// </summary>
    ImageChoice getImages() const;
    void setImages(ImageChoice value);

    /// <summary>
    /// Base URL of the data plane for this run; the path of an operation is appended to it.
    /// </summary>
    std::string getEndpoint() const;
    void setEndpoint(std::string value);

    /// <summary>
    /// 1 is next; null unless queued.
    /// </summary>
    std::optional<std::int32_t> getQueuePosition() const;
    void setQueuePosition(std::optional<std::int32_t> value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getLiveWorkers() const;
    void setLiveWorkers(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    Progress getProgress() const;
    void setProgress(Progress value);

    /// <summary>
    ///
    /// </summary>
    std::string getCreatedAt() const;
    void setCreatedAt(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getUpdatedAt() const;
    void setUpdatedAt(std::string value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Run_id = "";
    RunState m_State;
    std::optional<std::string> m_Reason;
    std::optional<bool> m_Retryable;
    std::string m_Benchmark_id = "";
    std::string m_Benchmark_version = "";
    std::string m_Manifest_sha256 = "";
    PolicyInfo m_Policy;
    RunMode m_Mode;
    bool m_ModeIsSet = false;
    PolicyServerView m_Policy_server;
    bool m_Policy_serverIsSet = false;
    std::int32_t m_Max_workers = 0;
    double m_Idle_timeout_s = 0.0;
    ImageChoice m_Images;
    std::string m_Endpoint = "";
    std::optional<std::int32_t> m_Queue_position;
    std::int32_t m_Live_workers = 0;
    Progress m_Progress;
    std::string m_Created_at = "";
    std::string m_Updated_at = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Run>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Run>>& vec, const std::string& json);

Run fromJsonValue_Run(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Run_MODEL_H_ */
