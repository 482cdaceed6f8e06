/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Comparison.h
 *
 * See scoring.md for every number here.
 */

#ifndef PROCTOR_MODEL_Comparison_MODEL_H_
#define PROCTOR_MODEL_Comparison_MODEL_H_

#include "ComparedRun.h"
#include <string>
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
/// See scoring.md for every number here.
/// </summary>
class Comparison
{
public:
    Comparison() = default;
    explicit Comparison(boost::json::value const& value);
    virtual ~Comparison() = default;

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
    /// Comparison members

    /// <summary>
    /// Id of the run that the others are compared with.
    /// </summary>
    std::string getBaseline() const;
    void setBaseline(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getBenchmarkId() const;
    void setBenchmarkId(std::string value);

    /// <summary>
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    /// </summary>
    std::string getManifestSha256() const;
    void setManifestSha256(std::string value);

    /// <summary>
    ///
    /// </summary>
    double getTolerance() const;
    void setTolerance(double value);

    /// <summary>
    /// One entry per run that was named, in that order.
    /// </summary>
    std::vector<ComparedRun> getRuns() const;
    void setRuns(std::vector<ComparedRun> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Baseline = "";
    std::string m_Benchmark_id = "";
    std::string m_Manifest_sha256 = "";
    double m_Tolerance = 0.0;
    std::vector<ComparedRun> m_Runs;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Comparison>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Comparison>>& vec, const std::string& json);

Comparison fromJsonValue_Comparison(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Comparison_MODEL_H_ */
