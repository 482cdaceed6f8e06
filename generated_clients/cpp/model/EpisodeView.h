/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * EpisodeView.h
 *
 * The episode that the observation belongs to.
 */

#ifndef PROCTOR_MODEL_EpisodeView_MODEL_H_
#define PROCTOR_MODEL_EpisodeView_MODEL_H_

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
/// The episode that the observation belongs to.
/// </summary>
class EpisodeView
{
public:
    EpisodeView() = default;
    explicit EpisodeView(boost::json::value const& value);
    virtual ~EpisodeView() = default;

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
    /// EpisodeView members

    /// <summary>
    ///
    /// </summary>
    std::string getEpisodeId() const;
    void setEpisodeId(std::string value);

    /// <summary>
    /// Position in the manifest.
    /// </summary>
    std::int32_t getIndex() const;
    void setIndex(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::string getTask() const;
    void setTask(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getInstruction() const;
    void setInstruction(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getAttempt() const;
    void setAttempt(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getStep() const;
    void setStep(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getMaxSteps() const;
    void setMaxSteps(std::int32_t value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Episode_id = "";
    std::int32_t m_Index = 0;
    std::string m_Task = "";
    std::string m_Instruction = "";
    std::int32_t m_Attempt = 0;
    std::int32_t m_Step = 0;
    std::int32_t m_Max_steps = 0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<EpisodeView>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<EpisodeView>>& vec, const std::string& json);

EpisodeView fromJsonValue_EpisodeView(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_EpisodeView_MODEL_H_ */
