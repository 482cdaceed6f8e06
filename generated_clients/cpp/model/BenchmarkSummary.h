/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * BenchmarkSummary.h
 *
 *
 */

#ifndef PROCTOR_MODEL_BenchmarkSummary_MODEL_H_
#define PROCTOR_MODEL_BenchmarkSummary_MODEL_H_

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
///
/// </summary>
class BenchmarkSummary
{
public:
    BenchmarkSummary() = default;
    explicit BenchmarkSummary(boost::json::value const& value);
    virtual ~BenchmarkSummary() = default;

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
    /// BenchmarkSummary members

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
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    /// </summary>
    std::string getManifestSha256() const;
    void setManifestSha256(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getEpisodesTotal() const;
    void setEpisodesTotal(std::int32_t value);

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
    std::string m_Manifest_sha256 = "";
    std::int32_t m_Episodes_total = 0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<BenchmarkSummary>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<BenchmarkSummary>>& vec, const std::string& json);

BenchmarkSummary fromJsonValue_BenchmarkSummary(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_BenchmarkSummary_MODEL_H_ */
