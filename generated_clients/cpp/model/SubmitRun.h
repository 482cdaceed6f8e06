/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * SubmitRun.h
 *
 *
 */

#ifndef PROCTOR_MODEL_SubmitRun_MODEL_H_
#define PROCTOR_MODEL_SubmitRun_MODEL_H_

#include "PolicyServer.h"
#include "CalibrationOptions.h"
#include "RunMode.h"
#include <string>
#include <map>
#include "PolicyInfo.h"
#include <vector>
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
class SubmitRun
{
public:
    SubmitRun() = default;
    explicit SubmitRun(boost::json::value const& value);
    virtual ~SubmitRun() = default;

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
    /// SubmitRun members

    /// <summary>
    ///
    /// </summary>
    std::string getBenchmarkId() const;
    void setBenchmarkId(std::string value);

    /// <summary>
    ///
    /// </summary>
    PolicyInfo getPolicy() const;
    void setPolicy(PolicyInfo value);

    /// <summary>
    /// Most live workers wanted; the server&#39;s limit when absent.
    /// </summary>
    std::int32_t getMaxWorkers() const;
    void setMaxWorkers(std::int32_t value);

    /// <summary>
    /// Lease of a session; the server&#39;s maximum when absent.
    /// </summary>
    double getIdleTimeoutS() const;
    void setIdleTimeoutS(double value);

    /// <summary>
    ///
    /// </summary>
    ImageChoice getImages() const;
    void setImages(ImageChoice value);

    /// <summary>
    ///
    /// </summary>
    CalibrationOptions getOptions() const;
    void setOptions(CalibrationOptions value);

    /// <summary>
    ///
    /// </summary>
    RunMode getMode() const;
    void setMode(RunMode value);

    /// <summary>
    ///
    /// </summary>
    PolicyServer getPolicyServer() const;
    void setPolicyServer(PolicyServer value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Benchmark_id = "";
    PolicyInfo m_Policy;
    std::int32_t m_Max_workers = 0;
    bool m_Max_workersIsSet = false;
    double m_Idle_timeout_s = 0.0;
    bool m_Idle_timeout_sIsSet = false;
    ImageChoice m_Images;
    bool m_ImagesIsSet = false;
    CalibrationOptions m_Options;
    bool m_OptionsIsSet = false;
    RunMode m_Mode;
    bool m_ModeIsSet = false;
    PolicyServer m_Policy_server;
    bool m_Policy_serverIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<SubmitRun>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<SubmitRun>>& vec, const std::string& json);

SubmitRun fromJsonValue_SubmitRun(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_SubmitRun_MODEL_H_ */
