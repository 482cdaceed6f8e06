/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/* The messages of the protocol, each behind those that it has members of. */
#pragma once

#include "members.h"

namespace proctor {

struct Action {
    static constexpr char const* schema_name = "Action";

    std::map<std::string, std::vector<double>> values{}; // Name → vector, exactly the entries of the benchmark's action space.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("values", self.values);
    }
};

/// About the part of this name.
struct PartAssumption {
    static constexpr char const* schema_name = "PartAssumption";

    std::optional<std::int32_t> start{};
    std::optional<std::int32_t> size{};
    std::optional<std::string> quantity{}; // A name of registry/quantities.yaml, or an extension.
    std::optional<std::string> unit{};
    std::optional<double> scale{};
    std::optional<std::string> frame{};
    std::optional<std::string> rotation{}; // A name of registry/rotations.yaml, or an extension.
    std::optional<std::string> relative_to{}; // A name of registry/relative_modes.yaml, or an extension.
    std::optional<double> gripper_open{};
    std::optional<double> gripper_closed{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("start", self.start);
        visitor.optional("size", self.size);
        visitor.optional("quantity", self.quantity);
        visitor.optional("unit", self.unit);
        visitor.optional("scale", self.scale);
        visitor.optional("frame", self.frame);
        visitor.optional("rotation", self.rotation);
        visitor.optional("relative_to", self.relative_to);
        visitor.optional("gripper_open", self.gripper_open);
        visitor.optional("gripper_closed", self.gripper_closed);
    }
};

/// About a vector. All members but `size` and `parts` are about each of its parts (CONV-004).
struct Assumption {
    static constexpr char const* schema_name = "Assumption";

    std::optional<std::int32_t> size{};
    std::optional<std::string> quantity{}; // A name of registry/quantities.yaml, or an extension.
    std::optional<std::string> unit{};
    std::optional<double> scale{};
    std::optional<std::string> frame{};
    std::optional<std::string> rotation{}; // A name of registry/rotations.yaml, or an extension.
    std::optional<std::string> relative_to{}; // A name of registry/relative_modes.yaml, or an extension.
    std::optional<double> gripper_open{};
    std::optional<double> gripper_closed{};
    std::optional<std::map<std::string, PartAssumption>> parts{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("size", self.size);
        visitor.optional("quantity", self.quantity);
        visitor.optional("unit", self.unit);
        visitor.optional("scale", self.scale);
        visitor.optional("frame", self.frame);
        visitor.optional("rotation", self.rotation);
        visitor.optional("relative_to", self.relative_to);
        visitor.optional("gripper_open", self.gripper_open);
        visitor.optional("gripper_closed", self.gripper_closed);
        visitor.optional("parts", self.parts);
    }
};

/// What the policy takes for granted; refused when the benchmark says otherwise (ATT-010). For the profile `conventions`.
struct Assumptions {
    static constexpr char const* schema_name = "Assumptions";

    std::optional<double> control_rate_hz{};
    std::optional<std::map<std::string, Assumption>> action{};
    std::optional<std::map<std::string, Assumption>> state{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("control_rate_hz", self.control_rate_hz);
        visitor.optional("action", self.action);
        visitor.optional("state", self.state);
    }
};

/// Who plays, by its own words; for the profile `attribution`.
struct Player {
    static constexpr char const* schema_name = "Player";

    std::string name{}; // Of the policy, as in `policy` of the run.
    std::optional<std::string> version{}; // Of the policy.
    std::optional<std::string> client{}; // The program that attaches and its version.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("client", self.client);
    }
};

struct AttachWorker {
    static constexpr char const* schema_name = "AttachWorker";

    std::string attach_key{}; // New for every attachment; repeated only to repeat a lost request.
    std::optional<bool> takeover{}; // Fence out a live session; false when absent. For the profile `sessions`.
    std::optional<Assumptions> assumes{};
    std::optional<Player> player{};
    std::optional<std::int32_t> first_episodes{}; // How many of the first episodes of the run are wanted; the session begins none behind them (SUB-005). All when absent. For the profile `subsets`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("attach_key", self.attach_key);
        visitor.optional("takeover", self.takeover);
        visitor.optional("assumes", self.assumes);
        visitor.optional("player", self.player);
        visitor.optional("first_episodes", self.first_episodes);
    }
};

/// Adjacent numbers of a vector, with every convention a policy could get wrong.
struct VectorPart {
    static constexpr char const* schema_name = "VectorPart";

    std::int32_t start{}; // Index of its first number in the vector.
    std::int32_t size{};
    std::string quantity{}; // A name of registry/quantities.yaml, or an extension.
    std::string unit{}; // A name of registry/units.yaml, or an extension.
    std::optional<double> scale{}; // A number times `scale` is in `unit`; 1 when absent.
    std::string frame{}; // A name of registry/frames.yaml, or an extension.
    std::string rotation{}; // A name of registry/rotations.yaml, or an extension.
    std::string relative_to{}; // A name of registry/relative_modes.yaml, or an extension.
    std::optional<double> gripper_open{}; // The value that means fully open.
    std::optional<double> gripper_closed{}; // The value that means fully closed.
    std::optional<std::string> description{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("start", self.start);
        visitor.required("size", self.size);
        visitor.required("quantity", self.quantity);
        visitor.required("unit", self.unit);
        visitor.optional("scale", self.scale);
        visitor.required("frame", self.frame);
        visitor.required("rotation", self.rotation);
        visitor.required("relative_to", self.relative_to);
        visitor.optional("gripper_open", self.gripper_open);
        visitor.optional("gripper_closed", self.gripper_closed);
        visitor.optional("description", self.description);
    }
};

/// One named vector of numbers, in parts: see [conventions](conventions.md#parts).
struct VectorSpace {
    static constexpr char const* schema_name = "VectorSpace";

    std::int32_t size{};
    std::optional<std::map<std::string, VectorPart>> parts{}; // Name → what these numbers are. Only descriptions of earlier drafts have none.
    std::optional<std::vector<double>> minimum{};
    std::optional<std::vector<double>> maximum{};
    std::string out_of_range{};
    std::optional<std::string> description{}; // What the numbers are.
    std::optional<std::vector<std::string>> tasks{}; // The tasks that have this entry; all of them when absent.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("size", self.size);
        visitor.optional("parts", self.parts);
        visitor.optional("minimum", self.minimum);
        visitor.optional("maximum", self.maximum);
        visitor.required("out_of_range", self.out_of_range);
        visitor.optional("description", self.description);
        visitor.optional("tasks", self.tasks);
    }
};

struct ImageSize {
    static constexpr char const* schema_name = "ImageSize";

    std::int32_t width{};
    std::int32_t height{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("width", self.width);
        visitor.required("height", self.height);
    }
};

struct SimulatorInfo {
    static constexpr char const* schema_name = "SimulatorInfo";

    std::string name{};
    std::string version{};
    std::optional<std::string> quality{}; // Named rendering quality, where there is one.
    std::optional<std::map<std::string, std::string>> sources{}; // File that the simulator [loads](simulator.md) → its SHA-256: an edit of it makes another manifest. Absent where none is announced.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.required("version", self.version);
        visitor.optional("quality", self.quality);
        visitor.optional("sources", self.sources);
    }
};

struct ImageSpace {
    static constexpr char const* schema_name = "ImageSpace";

    std::int32_t channels{};
    std::string description{};
    std::optional<std::vector<std::string>> tasks{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("channels", self.channels);
        visitor.required("description", self.description);
        visitor.optional("tasks", self.tasks);
    }
};

struct TensorSpace {
    static constexpr char const* schema_name = "TensorSpace";

    std::string dtype{};
    std::vector<std::int32_t> shape{};
    std::string description{};
    std::optional<std::vector<std::string>> tasks{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("dtype", self.dtype);
        visitor.required("shape", self.shape);
        visitor.required("description", self.description);
        visitor.optional("tasks", self.tasks);
    }
};

struct ObservationSpace {
    static constexpr char const* schema_name = "ObservationSpace";

    std::map<std::string, VectorSpace> state{};
    std::map<std::string, ImageSpace> images{};
    std::map<std::string, TensorSpace> tensors{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("state", self.state);
        visitor.required("images", self.images);
        visitor.required("tensors", self.tensors);
    }
};

/// Everything about a benchmark that can change a score.
struct Benchmark {
    static constexpr char const* schema_name = "Benchmark";

    std::string benchmark_id{};
    std::string version{};
    std::string title{};
    std::string description{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::int32_t episodes_total{};
    std::vector<std::string> tasks{};
    std::optional<std::map<std::string, std::string>> task_goals{}; // Task → when its goal holds, in a sentence for people; absent where nothing is said.
    std::vector<std::string> splits{};
    std::optional<std::vector<std::string>> sealed_splits{}; // Splits whose seeds the host draws in secret; none when absent.
    std::optional<std::string> seeds_sha256{}; // What the host commits itself to without showing it, the SHA-256 of a secret salt and the sealed seeds. With both disclosed later, anyone can prove which seeds were played.
    double control_rate_hz{}; // Actions per simulated second.
    std::int32_t max_steps{}; // Steps after which an episode is truncated.
    std::int32_t max_chunk{};
    std::int32_t max_attempts{};
    std::int32_t max_faults{};
    std::string success_rule{}; // A `SuccessRule`, or one of a later version.
    std::map<std::string, VectorSpace> action_space{}; // Name of an action value → what it means.
    ObservationSpace observation_space{};
    std::vector<ImageSize> image_sizes{}; // Sizes that may be chosen at submit; the first is the default.
    std::vector<std::string> image_codecs{}; // Codecs that may be chosen at submit; the first is the default.
    SimulatorInfo simulator{};
    std::optional<std::string> unavailable_reason{}; // Why a run cannot be submitted here now, and the cure; null when it can.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("version", self.version);
        visitor.required("title", self.title);
        visitor.required("description", self.description);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("episodes_total", self.episodes_total);
        visitor.required("tasks", self.tasks);
        visitor.optional("task_goals", self.task_goals);
        visitor.required("splits", self.splits);
        visitor.optional("sealed_splits", self.sealed_splits);
        visitor.optional("seeds_sha256", self.seeds_sha256);
        visitor.required("control_rate_hz", self.control_rate_hz);
        visitor.required("max_steps", self.max_steps);
        visitor.required("max_chunk", self.max_chunk);
        visitor.required("max_attempts", self.max_attempts);
        visitor.required("max_faults", self.max_faults);
        visitor.required("success_rule", self.success_rule);
        visitor.required("action_space", self.action_space);
        visitor.required("observation_space", self.observation_space);
        visitor.required("image_sizes", self.image_sizes);
        visitor.required("image_codecs", self.image_codecs);
        visitor.required("simulator", self.simulator);
        visitor.required("unavailable_reason", self.unavailable_reason);
    }
};

struct BenchmarkSummary {
    static constexpr char const* schema_name = "BenchmarkSummary";

    std::string benchmark_id{};
    std::string version{};
    std::string title{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::int32_t episodes_total{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("version", self.version);
        visitor.required("title", self.title);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("episodes_total", self.episodes_total);
    }
};

struct BenchmarkList {
    static constexpr char const* schema_name = "BenchmarkList";

    std::vector<BenchmarkSummary> benchmarks{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmarks", self.benchmarks);
    }
};

struct OutcomeCounts {
    static constexpr char const* schema_name = "OutcomeCounts";

    std::int32_t total{}; // All episodes.
    std::int32_t success{};
    std::int32_t failure{};
    std::int32_t abandoned{}; // Scored 0, because the last attempt was closed.
    std::int32_t unscored{}; // Without a result so far.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("total", self.total);
        visitor.required("success", self.success);
        visitor.required("failure", self.failure);
        visitor.required("abandoned", self.abandoned);
        visitor.required("unscored", self.unscored);
    }
};

struct GroupScore {
    static constexpr char const* schema_name = "GroupScore";

    OutcomeCounts counts{};
    std::optional<double> mean{};
    std::optional<double> success_rate{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("counts", self.counts);
        visitor.required("mean", self.mean);
        visitor.required("success_rate", self.success_rate);
    }
};

/// How a second person judged a sample of the episodes of a run; see profiles/physical.md.
struct SecondJudgements {
    static constexpr char const* schema_name = "SecondJudgements";

    std::int32_t drawn{}; // Episodes of the sample with a first judgement.
    std::int32_t judgements{}; // Those of them with a second one.
    std::vector<std::string> judges{}; // Names of the second judges that are not their accounts.
    std::int32_t both{}; // Episodes that both judges called a success.
    std::int32_t first_alone{}; // Those that the first judge alone called one.
    std::int32_t second_alone{}; // Those that the second judge alone called one.
    std::int32_t neither{}; // Those that no judge called one.
    std::optional<double> kappa{}; // Cohen's kappa of these; null where chance alone would make them agree.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("drawn", self.drawn);
        visitor.required("judgements", self.judgements);
        visitor.required("judges", self.judges);
        visitor.required("both", self.both);
        visitor.required("first_alone", self.first_alone);
        visitor.required("second_alone", self.second_alone);
        visitor.required("neither", self.neither);
        visitor.required("kappa", self.kappa);
    }
};

/// 95 % interval.
struct Interval {
    static constexpr char const* schema_name = "Interval";

    double low{};
    double high{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("low", self.low);
        visitor.required("high", self.high);
    }
};

/// Of the `get_score` of the run.
struct EntryScore {
    static constexpr char const* schema_name = "EntryScore";

    double score{};
    double success_rate{};
    Interval success_interval{};
    Interval mean_interval{};
    OutcomeCounts counts{};
    std::optional<std::string> judged_by{}; // With the profile `physical`: `people` of the host.
    std::optional<SecondJudgements> second_judge{};
    std::optional<std::map<std::string, GroupScore>> by_task{}; // Absent where the server does not show it, such as for many tasks.
    std::optional<std::map<std::string, GroupScore>> by_split{}; // Absent where the server does not show it, such as for many splits.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("score", self.score);
        visitor.required("success_rate", self.success_rate);
        visitor.required("success_interval", self.success_interval);
        visitor.required("mean_interval", self.mean_interval);
        visitor.required("counts", self.counts);
        visitor.optional("judged_by", self.judged_by);
        visitor.optional("second_judge", self.second_judge);
        visitor.optional("by_task", self.by_task);
        visitor.optional("by_split", self.by_split);
    }
};

struct EntryFlag {
    static constexpr char const* schema_name = "EntryFlag";

    std::string reason{};
    std::string flagged_at{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("reason", self.reason);
        visitor.required("flagged_at", self.flagged_at);
    }
};

/// The `select` of a run, as it was submitted.
struct SelectionView {
    static constexpr char const* schema_name = "SelectionView";

    std::optional<std::vector<std::string>> tasks{};
    std::optional<std::vector<std::string>> splits{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("tasks", self.tasks);
        visitor.optional("splits", self.splits);
    }
};

/// A `PolicyInfo` as it was submitted. A run of an earlier server may have a homepage of another form.
struct RunPolicy {
    static constexpr char const* schema_name = "RunPolicy";

    std::string name{};
    std::optional<std::string> version{};
    std::optional<std::string> submitter{};
    std::optional<std::string> homepage{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("submitter", self.submitter);
        visitor.optional("homepage", self.homepage);
    }
};

struct BoardEntry {
    static constexpr char const* schema_name = "BoardEntry";

    std::string entry_id{}; // Names the entry in every path.
    std::string run_id{};
    std::string submitter{}; // Name of the account that submitted the run.
    std::string benchmark_id{};
    std::string benchmark_version{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::optional<SelectionView> select{};
    RunPolicy policy{};
    std::string model_name{};
    bool is_public{};
    std::optional<std::string> model_type{};
    std::optional<std::string> organisation{};
    std::optional<std::string> homepage{};
    std::optional<std::string> code_url{};
    std::optional<std::string> notes{};
    std::string state{};
    std::optional<EntryFlag> flag{};
    std::string level{}; // What is known of the score: `reported` by the server alone; `signed`, for the run has a record that this host signs; `sealed`, for its seeds were drawn after the host was committed to the policy.
    std::int32_t attempts{}; // How many runs of the benchmark the account has submitted until now, published or not.
    EntryScore score{};
    std::string published_at{}; // When the entry was made.
    std::string changed_at{}; // When the description, the state or the flag changed for the last time.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("entry_id", self.entry_id);
        visitor.required("run_id", self.run_id);
        visitor.required("submitter", self.submitter);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("benchmark_version", self.benchmark_version);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.optional("select", self.select);
        visitor.required("policy", self.policy);
        visitor.required("model_name", self.model_name);
        visitor.required("is_public", self.is_public);
        visitor.optional("model_type", self.model_type);
        visitor.optional("organisation", self.organisation);
        visitor.optional("homepage", self.homepage);
        visitor.optional("code_url", self.code_url);
        visitor.optional("notes", self.notes);
        visitor.required("state", self.state);
        visitor.optional("flag", self.flag);
        visitor.required("level", self.level);
        visitor.required("attempts", self.attempts);
        visitor.required("score", self.score);
        visitor.required("published_at", self.published_at);
        visitor.required("changed_at", self.changed_at);
    }
};

struct BoardEntryList {
    static constexpr char const* schema_name = "BoardEntryList";

    std::vector<BoardEntry> entries{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("entries", self.entries);
        visitor.required("next_cursor", self.next_cursor);
    }
};

/// One of score, count, echo, delay, fault.
using CalibrationTask = std::string;

/// One of any_step, last_step.
using SuccessRule = std::string;

/// Only for the benchmark `calibration`, which the submitter shapes.
struct CalibrationOptions {
    static constexpr char const* schema_name = "CalibrationOptions";

    std::optional<std::vector<CalibrationTask>> tasks{}; // One entry per episode, in order; one `score` episode when absent.
    std::optional<std::int32_t> max_steps{}; // 10 when absent.
    std::optional<SuccessRule> success_rule{};
    std::optional<std::int32_t> max_attempts{}; // 3 when absent. For the profile `sessions`.
    std::optional<std::int32_t> max_faults{}; // 3 when absent. For the profile `faults`.
    std::optional<bool> sealed{}; // Whether the seeds of the split `odd` are sealed; false when absent. Only for servers that announce the profile `sealed_seeds`.
    std::optional<double> queue_s{}; // Seconds for which the run stays queued after submit and after resume; 0 when absent. For the profile `control`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("tasks", self.tasks);
        visitor.optional("max_steps", self.max_steps);
        visitor.optional("success_rule", self.success_rule);
        visitor.optional("max_attempts", self.max_attempts);
        visitor.optional("max_faults", self.max_faults);
        visitor.optional("sealed", self.sealed);
        visitor.optional("queue_s", self.queue_s);
    }
};

struct Checkpoint {
    static constexpr char const* schema_name = "Checkpoint";

    std::int64_t tree_size{};
    std::string root_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::string note{}; // The signed note, which says both as well.
    std::string keyid{}; // Of the key of `list_keys` that signed it.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("tree_size", self.tree_size);
        visitor.required("root_sha256", self.root_sha256);
        visitor.required("note", self.note);
        visitor.required("keyid", self.keyid);
    }
};

struct ComparedTask {
    static constexpr char const* schema_name = "ComparedTask";

    std::int32_t paired{};
    std::optional<double> baseline_mean{};
    std::optional<double> mean{};
    std::optional<double> difference{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("paired", self.paired);
        visitor.required("baseline_mean", self.baseline_mean);
        visitor.required("mean", self.mean);
        visitor.required("difference", self.difference);
    }
};

/// One run beside the baseline. A pair is an episode that both have scored.
struct ComparedRun {
    static constexpr char const* schema_name = "ComparedRun";

    std::string run_id{};
    bool complete{}; // Both runs have scored every episode.
    bool release{}; // Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
    std::int32_t paired{}; // Number of pairs.
    std::optional<double> baseline_mean{}; // Mean score of the baseline over the pairs.
    std::optional<double> mean{}; // Mean score of the run over the pairs.
    std::optional<double> difference{}; // Baseline minus run: positive when the run is worse.
    std::int32_t wins{}; // Pairs in which the run alone succeeds.
    std::int32_t losses{}; // Pairs in which the baseline alone succeeds.
    std::int32_t ties{}; // Pairs in which both succeed or neither does.
    double p_value{}; // McNemar's exact test, two-sided.
    std::map<std::string, ComparedTask> by_task{}; // Task → the pairs of its episodes.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("run_id", self.run_id);
        visitor.required("complete", self.complete);
        visitor.required("release", self.release);
        visitor.required("paired", self.paired);
        visitor.required("baseline_mean", self.baseline_mean);
        visitor.required("mean", self.mean);
        visitor.required("difference", self.difference);
        visitor.required("wins", self.wins);
        visitor.required("losses", self.losses);
        visitor.required("ties", self.ties);
        visitor.required("p_value", self.p_value);
        visitor.required("by_task", self.by_task);
    }
};

/// See scoring.md for every number here.
struct Comparison {
    static constexpr char const* schema_name = "Comparison";

    std::string baseline{}; // Id of the run that the others are compared with.
    std::string benchmark_id{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    double tolerance{};
    std::vector<ComparedRun> runs{}; // One entry per run that was named, in that order.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("baseline", self.baseline);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("tolerance", self.tolerance);
        visitor.required("runs", self.runs);
    }
};

struct ConsistencyProof {
    static constexpr char const* schema_name = "ConsistencyProof";

    std::int64_t old_size{};
    std::int64_t new_size{};
    std::vector<std::string> hashes{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("old_size", self.old_size);
        visitor.required("new_size", self.new_size);
        visitor.required("hashes", self.hashes);
    }
};

/// The `player` of an `attach_worker`.
struct PlayerView {
    static constexpr char const* schema_name = "PlayerView";

    std::string name{};
    std::optional<std::string> version{};
    std::optional<std::string> client{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("client", self.client);
    }
};

/// One of success, failure, abandoned.
using Outcome = std::string;

struct EpisodeResult {
    static constexpr char const* schema_name = "EpisodeResult";

    std::string episode_id{};
    std::int32_t index{}; // Position in the manifest.
    std::string task{};
    std::string split{};
    std::optional<std::int64_t> seed{}; // Absent where `sealed_splits` of the manifest of the run names the split.
    std::int32_t attempt{}; // The attempt that was scored.
    std::int32_t faults{}; // How often the simulator broke, or a trial was void (FAULT-009).
    Outcome outcome{};
    double score{}; // From 0 to 1.
    std::int32_t steps{}; // Actions executed in the attempt.
    bool terminated{}; // The task ended by itself.
    bool truncated{}; // The step limit ended the episode.
    double think_s{}; // Time between turns that the policy took.
    std::string finished_at{};
    std::optional<PlayerView> player{};
    std::optional<std::int32_t> clipped_actions{}; // Actions of the attempt with a number outside of a range that is declared `clip`; for the profile `attribution`.
    std::optional<double> total_reward{}; // Sum of the rewards of the attempt, its return; for the profile `attribution`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("index", self.index);
        visitor.required("task", self.task);
        visitor.required("split", self.split);
        visitor.optional("seed", self.seed);
        visitor.required("attempt", self.attempt);
        visitor.required("faults", self.faults);
        visitor.required("outcome", self.outcome);
        visitor.required("score", self.score);
        visitor.required("steps", self.steps);
        visitor.required("terminated", self.terminated);
        visitor.required("truncated", self.truncated);
        visitor.required("think_s", self.think_s);
        visitor.required("finished_at", self.finished_at);
        visitor.optional("player", self.player);
        visitor.optional("clipped_actions", self.clipped_actions);
        visitor.optional("total_reward", self.total_reward);
    }
};

/// One of pending, in_progress, scored.
using EpisodeStatus = std::string;

/// That a worker has left an episode, by its own words; for the profile `reasons`.
struct Leaving {
    static constexpr char const* schema_name = "Leaving";

    std::int32_t attempt{}; // The attempt that was in play.
    std::string reason{}; // Why the worker has left it.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("attempt", self.attempt);
        visitor.required("reason", self.reason);
    }
};

struct Episode {
    static constexpr char const* schema_name = "Episode";

    std::string episode_id{};
    std::int32_t index{}; // Position in the manifest.
    std::string task{};
    std::string split{};
    EpisodeStatus status{};
    std::int32_t attempt{}; // The current or next attempt.
    std::int32_t faults{}; // How often the simulator broke, or a trial was void (FAULT-009).
    std::optional<std::string> policy_fault{}; // In a run with mode `push`: what the policy did wrong when it last ended an attempt of this episode.
    std::optional<Leaving> last_left{};
    std::optional<EpisodeResult> result{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("index", self.index);
        visitor.required("task", self.task);
        visitor.required("split", self.split);
        visitor.required("status", self.status);
        visitor.required("attempt", self.attempt);
        visitor.required("faults", self.faults);
        visitor.optional("policy_fault", self.policy_fault);
        visitor.optional("last_left", self.last_left);
        visitor.optional("result", self.result);
    }
};

struct EpisodeList {
    static constexpr char const* schema_name = "EpisodeList";

    std::vector<Episode> episodes{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episodes", self.episodes);
        visitor.required("next_cursor", self.next_cursor);
    }
};

/// The part of a benchmark that is played, all of it where a member is absent; for the profile `subsets`.
struct EpisodeSelection {
    static constexpr char const* schema_name = "EpisodeSelection";

    std::optional<std::vector<std::string>> tasks{};
    std::optional<std::vector<std::string>> splits{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("tasks", self.tasks);
        visitor.optional("splits", self.splits);
    }
};

/// The episode that the observation belongs to.
struct EpisodeView {
    static constexpr char const* schema_name = "EpisodeView";

    std::string episode_id{}; // Names the episode within the run.
    std::int32_t index{}; // Position in the manifest.
    std::string task{}; // What kind of episode it is.
    std::string instruction{}; // What the policy is to do, in words.
    std::int32_t attempt{}; // Number of this playing of it, from 1.
    std::int32_t step{}; // Actions executed in this attempt.
    std::int32_t max_steps{}; // Steps after which it is truncated.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("index", self.index);
        visitor.required("task", self.task);
        visitor.required("instruction", self.instruction);
        visitor.required("attempt", self.attempt);
        visitor.required("step", self.step);
        visitor.required("max_steps", self.max_steps);
    }
};

/// The simulator broke; the episode began again, at no cost to the policy. Nothing of the chunk counts as executed. A turn that ends an episode has its result instead, and `list_episodes` the faults of the next one.
struct Fault {
    static constexpr char const* schema_name = "Fault";

    std::string episode_id{}; // Which episode began again.
    std::int32_t faults{}; // Faults of this episode so far.
    std::string detail{}; // What happened, for people.
    std::optional<bool> is_void{}; // True where no simulator broke: a person said that the trial does not count; with the profile `physical`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_id", self.episode_id);
        visitor.required("faults", self.faults);
        visitor.required("detail", self.detail);
        visitor.optional("is_void", self.is_void);
    }
};

struct FlagEntry {
    static constexpr char const* schema_name = "FlagEntry";

    bool flagged{}; // False takes the flag back.
    std::string reason{}; // Shown with the entry.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("flagged", self.flagged);
        visitor.required("reason", self.reason);
    }
};

struct Heartbeat {
    static constexpr char const* schema_name = "Heartbeat";

    std::string session_id{}; // Session of `attach_worker`.
    std::optional<std::string> reason{}; // Why the worker leaves the episode in play, for people (RSN-001). For the profile `reasons`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.optional("reason", self.reason);
    }
};

struct HistoryLeaf {
    static constexpr char const* schema_name = "HistoryLeaf";

    std::int64_t index{};
    std::string leaf{}; // A JSON text, whose UTF-8 is what the tree has; board.md has its members.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("index", self.index);
        visitor.required("leaf", self.leaf);
    }
};

struct HistoryPage {
    static constexpr char const* schema_name = "HistoryPage";

    std::vector<HistoryLeaf> leaves{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("leaves", self.leaves);
        visitor.required("next_cursor", self.next_cursor);
    }
};

/// Row 0 on top; raw is height × width × channels bytes. The order of [channels](play.md#numbers-and-pictures).
struct Image {
    static constexpr char const* schema_name = "Image";

    std::string codec{};
    std::int32_t width{};
    std::int32_t height{};
    std::int32_t channels{};
    std::string data{}; // Base64 with padding in JSON; `bin` in MessagePack.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("codec", self.codec);
        visitor.required("width", self.width);
        visitor.required("height", self.height);
        visitor.required("channels", self.channels);
        visitor.required("data", self.data);
    }
};

/// Recorded with the result, because it changes the score.
struct ImageChoice {
    static constexpr char const* schema_name = "ImageChoice";

    std::string codec{};
    std::int32_t width{};
    std::int32_t height{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("codec", self.codec);
        visitor.required("width", self.width);
        visitor.required("height", self.height);
    }
};

struct ImportedPolicy {
    static constexpr char const* schema_name = "ImportedPolicy";

    std::string name{};
    std::optional<std::string> version{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.required("version", self.version);
    }
};

struct InclusionProof {
    static constexpr char const* schema_name = "InclusionProof";

    std::int64_t leaf_index{};
    std::int64_t tree_size{};
    std::vector<std::string> hashes{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("leaf_index", self.leaf_index);
        visitor.required("tree_size", self.tree_size);
        visitor.required("hashes", self.hashes);
    }
};

/// How people judged the run; with the profile `physical`.
struct JudgedRun {
    static constexpr char const* schema_name = "JudgedRun";

    std::vector<std::string> judges{}; // Names of the people that are not their accounts, as in records.
    std::int32_t judgements{}; // Episodes with a judgement.
    bool blind{}; // Whether each judge knew nothing of the policy.
    std::map<std::string, std::int32_t> voids{}; // How many trials were void, by reason.
    std::map<std::string, std::string> notes{}; // What judges wrote, by episode_id.
    std::optional<std::map<std::string, std::string>> cells{}; // The cell at which an episode was judged, by episode_id; absent where the benchmark has one cell.
    std::optional<SecondJudgements> second{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("judges", self.judges);
        visitor.required("judgements", self.judgements);
        visitor.required("blind", self.blind);
        visitor.required("voids", self.voids);
        visitor.required("notes", self.notes);
        visitor.optional("cells", self.cells);
        visitor.optional("second", self.second);
    }
};

struct PublicKey {
    static constexpr char const* schema_name = "PublicKey";

    std::string keyid{}; // `SHA256:` and the SHA-256 of the key in hexadecimal digits.
    std::string algorithm{}; // `ed25519`, or another one of a later version.
    std::string public_key{}; // Its 32 bytes.
    std::string created_at{};
    std::optional<std::string> retired_at{}; // When it signed for the last time; null for the key in use.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("keyid", self.keyid);
        visitor.required("algorithm", self.algorithm);
        visitor.required("public_key", self.public_key);
        visitor.required("created_at", self.created_at);
        visitor.required("retired_at", self.retired_at);
    }
};

struct KeyList {
    static constexpr char const* schema_name = "KeyList";

    std::vector<PublicKey> keys{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("keys", self.keys);
    }
};

struct Lease {
    static constexpr char const* schema_name = "Lease";

    std::string expires_at{}; // When the session ends, unless a request extends it.
    double idle_timeout_s{}; // Length of the lease.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("expires_at", self.expires_at);
        visitor.required("idle_timeout_s", self.idle_timeout_s);
    }
};

struct Limits {
    static constexpr char const* schema_name = "Limits";

    std::int64_t max_body_bytes{}; // Longest request body that is read, except by `import_record`.
    std::int32_t max_workers{}; // Most live workers a run may ask for.
    std::int32_t max_chunk{}; // Most actions in one predict; a benchmark may allow fewer.
    double idle_timeout_s_min{}; // Shortest lease of a session that a run may have.
    double idle_timeout_s_max{}; // Longest lease of a session that a run may have.
    std::int32_t wait_s_max{}; // Longest wait that a long-poll is granted.
    std::optional<std::int32_t> max_header_bytes{}; // Longest request line with its headers that is read; for the profile `limits`.
    std::optional<double> header_timeout_s{}; // Time in which the headers of a request are complete, from its first byte; for the profile `limits`.
    std::optional<double> body_timeout_s{}; // Time in which a part of a body arrives after the headers of its request; for the profile `limits`.
    std::optional<double> heartbeat_s_max{}; // Longest time that a session lives without a new turn, or its `idle_timeout_s` if that is longer; for the profile `limits`.
    std::optional<double> unused_s_max{}; // When others wait: the time after which a run without a worker, or a session without a turn, may make room; for the profile `limits`.
    std::optional<std::int64_t> max_control_body_bytes{}; // Longest body that is read of a request other than `predict` and `import_record`, where it is less than `max_body_bytes`; for the profile `limits`.
    std::optional<std::int32_t> max_open_runs{}; // Most runs of one account that are queued, ready, running or stopping; for the profile `limits`.
    std::optional<std::int64_t> max_idempotency_keys{}; // Most Idempotency-Keys that one account may use; for the profile `limits`.
    std::optional<std::int64_t> max_stored_bytes{}; // Most bytes that one account may have stored, see [LIM-010](profiles/limits.md). For the profile `limits`.
    std::optional<std::int64_t> max_record_bytes{}; // Longest archive that `import_record` reads; for the profile `record_import`.
    std::optional<std::int32_t> max_waiting_imports{}; // Most imports of one account that are not `finished`; for the profile `record_import`.
    std::optional<std::int64_t> max_imported_bytes{}; // Most bytes that the archives of one account may have together; for the profile `record_import`.
    std::optional<double> run_keep_days{}; // Days without a change after which a run that has completed, failed or been stopped may be deleted; when absent, none is. For the profile `deletion`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("max_body_bytes", self.max_body_bytes);
        visitor.required("max_workers", self.max_workers);
        visitor.required("max_chunk", self.max_chunk);
        visitor.required("idle_timeout_s_min", self.idle_timeout_s_min);
        visitor.required("idle_timeout_s_max", self.idle_timeout_s_max);
        visitor.required("wait_s_max", self.wait_s_max);
        visitor.optional("max_header_bytes", self.max_header_bytes);
        visitor.optional("header_timeout_s", self.header_timeout_s);
        visitor.optional("body_timeout_s", self.body_timeout_s);
        visitor.optional("heartbeat_s_max", self.heartbeat_s_max);
        visitor.optional("unused_s_max", self.unused_s_max);
        visitor.optional("max_control_body_bytes", self.max_control_body_bytes);
        visitor.optional("max_open_runs", self.max_open_runs);
        visitor.optional("max_idempotency_keys", self.max_idempotency_keys);
        visitor.optional("max_stored_bytes", self.max_stored_bytes);
        visitor.optional("max_record_bytes", self.max_record_bytes);
        visitor.optional("max_waiting_imports", self.max_waiting_imports);
        visitor.optional("max_imported_bytes", self.max_imported_bytes);
        visitor.optional("run_keep_days", self.run_keep_days);
    }
};

/// C order, little-endian; a bool is one byte, 0 or 1.
struct Tensor {
    static constexpr char const* schema_name = "Tensor";

    std::string dtype{};
    std::vector<std::int64_t> shape{};
    std::string data{}; // Base64 with padding in JSON; `bin` in MessagePack.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("dtype", self.dtype);
        visitor.required("shape", self.shape);
        visitor.required("data", self.data);
    }
};

struct Observation {
    static constexpr char const* schema_name = "Observation";

    std::map<std::string, std::vector<double>> state{};
    std::map<std::string, Image> images{};
    std::map<std::string, Tensor> tensors{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("state", self.state);
        visitor.required("images", self.images);
        visitor.required("tensors", self.tensors);
    }
};

/// One of last, all.
using Observe = std::string;

struct ProtocolRange {
    static constexpr char const* schema_name = "ProtocolRange";

    std::string min{}; // Lowest version that is spoken.
    std::string max{}; // Highest version that is spoken.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("min", self.min);
        visitor.required("max", self.max);
    }
};

/// What a policy server says of itself.
struct PolicyDescription {
    static constexpr char const* schema_name = "PolicyDescription";

    std::string name{};
    std::optional<std::string> version{};
    ProtocolRange protocol{};
    std::int32_t max_sessions{}; // Most episodes that it plays at a time.
    std::optional<Assumptions> assumes{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.required("protocol", self.protocol);
        visitor.required("max_sessions", self.max_sessions);
        visitor.optional("assumes", self.assumes);
    }
};

struct PolicyInfo {
    static constexpr char const* schema_name = "PolicyInfo";

    std::string name{}; // What the policy is called in results.
    std::optional<std::string> version{}; // Which state of it, for example a checkpoint.
    std::optional<std::string> submitter{}; // Who submits it.
    std::optional<std::string> homepage{}; // Where to read about it.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.optional("version", self.version);
        visitor.optional("submitter", self.submitter);
        visitor.optional("homepage", self.homepage);
    }
};

/// One of proctor, openai_chat, openai_completions.
using PolicyProtocol = std::string;

/// The policy is ready for this attempt and no other.
struct PolicyReset {
    static constexpr char const* schema_name = "PolicyReset";

    std::string session_id{};
    std::string episode_id{};
    std::int32_t attempt{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.required("episode_id", self.episode_id);
        visitor.required("attempt", self.attempt);
    }
};

/// Where the server finds the policy of a run with mode `push`, and how it calls it.
struct PolicyServer {
    static constexpr char const* schema_name = "PolicyServer";

    std::string url{}; // Base URL, without user, query or fragment; the path of an operation is appended to it.
    PolicyProtocol protocol{};
    std::optional<std::string> api_key{}; // Sent as bearer token with every call, and never shown.
    std::optional<std::string> model{}; // Which model is asked, where a protocol knows several.
    std::optional<double> call_timeout_s{}; // Time for one call, from connecting to the last byte of its answer; 30 when absent.
    std::optional<std::int32_t> max_concurrent{}; // Most episodes played and calls made at a time; as many as the policy, the run and the server allow when absent.
    std::optional<std::int32_t> max_retries{}; // How often a call that was not answered is repeated; 3 when absent.
    std::optional<std::map<std::string, double>> generation{}; // Numbers that a chat completion is asked with, such as `temperature` and `max_tokens`; for `openai_chat` and `openai_completions` alone.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("url", self.url);
        visitor.required("protocol", self.protocol);
        visitor.optional("api_key", self.api_key);
        visitor.optional("model", self.model);
        visitor.optional("call_timeout_s", self.call_timeout_s);
        visitor.optional("max_concurrent", self.max_concurrent);
        visitor.optional("max_retries", self.max_retries);
        visitor.optional("generation", self.generation);
    }
};

/// The policy server of a run with mode `push`, with what was left open filled in, and without its key.
struct PolicyServerView {
    static constexpr char const* schema_name = "PolicyServerView";

    std::string url{};
    std::string protocol{}; // A `PolicyProtocol`, or one of a later version.
    bool has_api_key{};
    std::optional<std::string> model{};
    double call_timeout_s{};
    std::int32_t max_concurrent{};
    std::int32_t max_retries{};
    std::optional<std::map<std::string, double>> generation{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("url", self.url);
        visitor.required("protocol", self.protocol);
        visitor.required("has_api_key", self.has_api_key);
        visitor.optional("model", self.model);
        visitor.required("call_timeout_s", self.call_timeout_s);
        visitor.required("max_concurrent", self.max_concurrent);
        visitor.required("max_retries", self.max_retries);
        visitor.optional("generation", self.generation);
    }
};

struct Predict {
    static constexpr char const* schema_name = "Predict";

    std::string session_id{}; // Session of `attach_worker`.
    std::int64_t seq{}; // Number of the turn, 1 for the first one; a repeat has the same number.
    std::vector<Action> actions{};
    std::optional<Observe> observe{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.required("seq", self.seq);
        visitor.required("actions", self.actions);
        visitor.optional("observe", self.observe);
    }
};

/// One of queued, ready, running, stopping, stopped, failed, completed.
using RunState = std::string;

/// One of none, possible.
using SideEffects = std::string;

struct ProblemItem {
    static constexpr char const* schema_name = "ProblemItem";

    std::string pointer{}; // JSON pointer into the body, to the faulty member or a part of it; or `query:name`, `header:name`, `path:name`; or `record:name`, with the name of a file in a record, or `archive`.
    std::string detail{}; // What is wrong there.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("pointer", self.pointer);
        visitor.required("detail", self.detail);
    }
};

/// RFC 9457, with what a client needs to decide on a retry.
struct Problem {
    static constexpr char const* schema_name = "Problem";

    std::string type{}; // `urn:proctor:problem:` and the code.
    std::string title{}; // What the code means.
    std::int32_t status{}; // Status of the response.
    std::string detail{}; // What happened and what to do about it.
    std::string code{}; // One of x-problems, or one of a later version.
    bool retryable{}; // Whether the same request can succeed later.
    SideEffects side_effects{};
    std::optional<std::vector<ProblemItem>> errors{};
    std::optional<std::string> requirement{}; // Id of the rule that was enforced.
    std::optional<RunState> state{};
    std::optional<std::int64_t> expected_seq{}; // Of `seq_out_of_order`: the next seq.
    std::optional<std::string> ended_by{}; // What ended the session, as far as the server still knows; `unknown` after a restart, and for a session that was taken over and whose successor has ended.
    std::optional<std::string> entry_id{}; // Of `result_published`: the entry of that result.
    std::optional<std::string> limit{}; // Of `quota_exceeded` and `no_capacity`: the limit that was reached, where the server names it.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("type", self.type);
        visitor.required("title", self.title);
        visitor.required("status", self.status);
        visitor.required("detail", self.detail);
        visitor.required("code", self.code);
        visitor.required("retryable", self.retryable);
        visitor.required("side_effects", self.side_effects);
        visitor.optional("errors", self.errors);
        visitor.optional("requirement", self.requirement);
        visitor.optional("state", self.state);
        visitor.optional("expected_seq", self.expected_seq);
        visitor.optional("ended_by", self.ended_by);
        visitor.optional("entry_id", self.entry_id);
        visitor.optional("limit", self.limit);
    }
};

struct Progress {
    static constexpr char const* schema_name = "Progress";

    std::int32_t episodes_total{}; // How many episodes the run has.
    std::int32_t episodes_scored{}; // Abandoned ones included.
    std::int32_t episodes_in_progress{}; // How many are played now.
    std::int32_t episodes_pending{}; // How many wait to be played.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episodes_total", self.episodes_total);
        visitor.required("episodes_scored", self.episodes_scored);
        visitor.required("episodes_in_progress", self.episodes_in_progress);
        visitor.required("episodes_pending", self.episodes_pending);
    }
};

/// What an entry says of itself; a member that is absent is not shown.
struct PublishEntry {
    static constexpr char const* schema_name = "PublishEntry";

    std::string model_name{}; // What the entry is called.
    bool is_public{}; // Whether others see the entry, and whether it has a rank.
    std::optional<std::string> model_type{}; // What kind of model it is, for example `VLA` or `diffusion policy`.
    std::optional<std::string> organisation{};
    std::optional<std::string> homepage{}; // Where to read about the model.
    std::optional<std::string> code_url{}; // Where its code is.
    std::optional<std::string> notes{}; // Anything else, for readers.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("model_name", self.model_name);
        visitor.required("is_public", self.is_public);
        visitor.optional("model_type", self.model_type);
        visitor.optional("organisation", self.organisation);
        visitor.optional("homepage", self.homepage);
        visitor.optional("code_url", self.code_url);
        visitor.optional("notes", self.notes);
    }
};

/// The ranks that an entry may have; absent for an entry that is flagged.
struct RankInterval {
    static constexpr char const* schema_name = "RankInterval";

    std::int32_t low{}; // The best one.
    std::int32_t high{}; // The worst one.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("low", self.low);
        visitor.required("high", self.high);
    }
};

struct RankedEntry {
    static constexpr char const* schema_name = "RankedEntry";

    BoardEntry entry{};
    std::optional<RankInterval> rank{};
    std::int32_t better{}; // How many entries are significantly better; 0 without a rank.
    std::int32_t worse{}; // How many entries are significantly worse; 0 without a rank.
    std::vector<std::string> letters{}; // Entries that cannot be distinguished have a letter in common, others have none in common; empty without a rank.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("entry", self.entry);
        visitor.optional("rank", self.rank);
        visitor.required("better", self.better);
        visitor.required("worse", self.worse);
        visitor.required("letters", self.letters);
    }
};

/// See board.md for every number here.
struct Ranking {
    static constexpr char const* schema_name = "Ranking";

    std::string benchmark_id{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::optional<std::int32_t> episodes_total{}; // How many episodes each entry has; null where the manifest has no entry.
    std::int32_t ranked{}; // How many entries have a rank.
    std::int64_t comparisons{}; // How many pairs of them were tested.
    double alpha{}; // How likely it is at most that any two equally good policies are distinguished; 0.05.
    std::optional<std::int32_t> differing_min{}; // Two entries that differ on fewer episodes can never be distinguished; null if the benchmark has fewer episodes.
    std::optional<std::int32_t> differing_enough{}; // Two entries that differ on so many episodes, all to the advantage of one, are distinguished, however the others fared; null if the benchmark has fewer episodes.
    std::vector<RankedEntry> rows{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("episodes_total", self.episodes_total);
        visitor.required("ranked", self.ranked);
        visitor.required("comparisons", self.comparisons);
        visitor.required("alpha", self.alpha);
        visitor.required("differing_min", self.differing_min);
        visitor.required("differing_enough", self.differing_enough);
        visitor.required("rows", self.rows);
        visitor.required("next_cursor", self.next_cursor);
    }
};

/// The first state that was another one; absent where every state was met.
struct ReplayDivergence {
    static constexpr char const* schema_name = "ReplayDivergence";

    std::int32_t episode_index{};
    std::int64_t attempt{};
    std::int64_t step{}; // After how many steps of the attempt the state was another one.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("episode_index", self.episode_index);
        visitor.required("attempt", self.attempt);
        visitor.required("step", self.step);
    }
};

/// As in a verdict (record.md); absent before the end of the replay, and where there is none.
struct RecordReplay {
    static constexpr char const* schema_name = "RecordReplay";

    std::string result{}; // `exact`, `outcome` or `diverged`.
    std::int32_t episodes{};
    std::int32_t exact{};
    std::int32_t outcome{};
    std::int32_t diverged{};
    std::optional<ReplayDivergence> first_divergence{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("result", self.result);
        visitor.required("episodes", self.episodes);
        visitor.required("exact", self.exact);
        visitor.required("outcome", self.outcome);
        visitor.required("diverged", self.diverged);
        visitor.optional("first_divergence", self.first_divergence);
    }
};

/// A record that was handed in, and what is known of it here.
struct RecordImport {
    static constexpr char const* schema_name = "RecordImport";

    std::string import_id{};
    std::string state{}; // `waiting` for simulators, `replaying`, or `finished`.
    std::string level{}; // `reported`: whole, by anyone; `signed` by a key that this server knows; `replayed` here with the same results; `diverged`: the replay came out otherwise.
    std::string level_text{}; // The level with who says it, as REC-031 has it.
    std::optional<std::string> signer{}; // Whose key signed the record, as this server knows it; null for a key that it does not know.
    std::string keyid{}; // Of the key that signed the record.
    std::string archive_sha256{};
    std::string statement_sha256{};
    std::int64_t size_bytes{};
    std::string run_id{}; // In the statement, as are the members below it.
    std::string benchmark_id{};
    std::string benchmark_version{};
    std::string manifest_sha256{};
    ImportedPolicy policy{};
    std::optional<double> score{}; // Null where an episode has no result.
    std::int32_t episodes{};
    std::int32_t episodes_replayed{}; // How many of them were simulated so far.
    std::optional<RecordReplay> replay{};
    std::optional<std::string> reason{}; // Why there is no replay.
    std::string imported_at{};
    std::optional<std::string> finished_at{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("import_id", self.import_id);
        visitor.required("state", self.state);
        visitor.required("level", self.level);
        visitor.required("level_text", self.level_text);
        visitor.required("signer", self.signer);
        visitor.required("keyid", self.keyid);
        visitor.required("archive_sha256", self.archive_sha256);
        visitor.required("statement_sha256", self.statement_sha256);
        visitor.required("size_bytes", self.size_bytes);
        visitor.required("run_id", self.run_id);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("benchmark_version", self.benchmark_version);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("policy", self.policy);
        visitor.required("score", self.score);
        visitor.required("episodes", self.episodes);
        visitor.required("episodes_replayed", self.episodes_replayed);
        visitor.optional("replay", self.replay);
        visitor.required("reason", self.reason);
        visitor.required("imported_at", self.imported_at);
        visitor.required("finished_at", self.finished_at);
    }
};

struct RecordImportList {
    static constexpr char const* schema_name = "RecordImportList";

    std::vector<RecordImport> imports{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("imports", self.imports);
        visitor.required("next_cursor", self.next_cursor);
    }
};

/// An attempt begins; whatever the policy remembers of this session is over.
struct ResetPolicy {
    static constexpr char const* schema_name = "ResetPolicy";

    std::string session_id{};
    std::optional<std::string> run_id{};
    Benchmark benchmark{};
    EpisodeView episode{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.optional("run_id", self.run_id);
        visitor.required("benchmark", self.benchmark);
        visitor.required("episode", self.episode);
    }
};

struct Run {
    static constexpr char const* schema_name = "Run";

    std::string run_id{}; // Names the run in every path.
    RunState state{};
    std::optional<std::string> reason{}; // Why the run is in this state, for people; never null when failed.
    std::optional<bool> retryable{}; // Whether a failed run may be resumed; null in other states.
    std::optional<std::string> failed_by{}; // Who made a run fail: the `policy`, the `simulator` or the `server`. In a failed run alone, where the server knows it.
    std::string benchmark_id{};
    std::string benchmark_version{}; // Version of the benchmark when the run was submitted.
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    RunPolicy policy{};
    std::optional<std::string> mode{}; // A `RunMode`, or one of a later version; `pull` when absent.
    std::optional<PolicyServerView> policy_server{};
    std::optional<bool> any_policy{}; // Whether workers may play for another policy than `policy`; for the profile `attribution`.
    std::optional<SelectionView> select{};
    std::int32_t max_workers{}; // Most live workers that it may have.
    double idle_timeout_s{}; // Lease of its sessions.
    ImageChoice images{};
    std::string endpoint{}; // Base URL of the data plane for this run; the path of an operation is appended to it.
    std::optional<std::int32_t> queue_position{}; // 1 is next; null unless queued.
    std::int32_t live_workers{}; // How many workers have a live session.
    Progress progress{};
    std::string created_at{}; // When it was submitted.
    std::string updated_at{}; // When it changed for the last time; a change that was taken back before it was shown need not count.
    std::optional<std::int32_t> runs_played_before{}; // How many runs of this benchmark its submitter had played before this run was played, deleted ones too; absent before this run is played (DEL-006). For the profile `deletion`.
    std::optional<JudgedRun> judged{};
    std::optional<std::string> account{}; // The account that owns the run. For the profile `accounts`.
    std::optional<std::int32_t> attempts_by_submitter{}; // How many runs of this benchmark its submitter had submitted, this one included; for the profile `record`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("run_id", self.run_id);
        visitor.required("state", self.state);
        visitor.required("reason", self.reason);
        visitor.required("retryable", self.retryable);
        visitor.optional("failed_by", self.failed_by);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("benchmark_version", self.benchmark_version);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.required("policy", self.policy);
        visitor.optional("mode", self.mode);
        visitor.optional("policy_server", self.policy_server);
        visitor.optional("any_policy", self.any_policy);
        visitor.optional("select", self.select);
        visitor.required("max_workers", self.max_workers);
        visitor.required("idle_timeout_s", self.idle_timeout_s);
        visitor.required("images", self.images);
        visitor.required("endpoint", self.endpoint);
        visitor.required("queue_position", self.queue_position);
        visitor.required("live_workers", self.live_workers);
        visitor.required("progress", self.progress);
        visitor.required("created_at", self.created_at);
        visitor.required("updated_at", self.updated_at);
        visitor.optional("runs_played_before", self.runs_played_before);
        visitor.optional("judged", self.judged);
        visitor.optional("account", self.account);
        visitor.optional("attempts_by_submitter", self.attempts_by_submitter);
    }
};

struct RunList {
    static constexpr char const* schema_name = "RunList";

    std::vector<Run> runs{};
    std::optional<std::string> next_cursor{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("runs", self.runs);
        visitor.required("next_cursor", self.next_cursor);
    }
};

/// One of pull, push.
using RunMode = std::string;

/// See scoring.md for every number here.
struct Score {
    static constexpr char const* schema_name = "Score";

    std::string run_id{};
    std::string benchmark_id{};
    std::string manifest_sha256{}; // The digest of a [manifest](benchmarks.md#the-manifest), which is all of a benchmark that can change a score. It is the same on every server (BEN-006).
    std::optional<SelectionView> select{};
    RunState state{};
    bool complete{}; // Every episode has a result.
    std::optional<double> score{}; // Null until complete.
    double score_low{}; // The score if every missing episode got 0.
    double score_high{}; // The score if every missing episode got 1.
    OutcomeCounts counts{};
    std::optional<double> success_rate{}; // Successes among the scored episodes.
    Interval success_interval{};
    std::optional<double> mean{}; // Mean over the scored episodes.
    Interval mean_interval{};
    std::map<std::string, GroupScore> by_task{};
    std::map<std::string, GroupScore> by_split{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("run_id", self.run_id);
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("manifest_sha256", self.manifest_sha256);
        visitor.optional("select", self.select);
        visitor.required("state", self.state);
        visitor.required("complete", self.complete);
        visitor.required("score", self.score);
        visitor.required("score_low", self.score_low);
        visitor.required("score_high", self.score_high);
        visitor.required("counts", self.counts);
        visitor.required("success_rate", self.success_rate);
        visitor.required("success_interval", self.success_interval);
        visitor.required("mean", self.mean);
        visitor.required("mean_interval", self.mean_interval);
        visitor.required("by_task", self.by_task);
        visitor.required("by_split", self.by_split);
    }
};

/// What a server says of itself before anyone authenticates.
struct Service {
    static constexpr char const* schema_name = "Service";

    std::string name{}; // Name of the server software.
    std::string version{}; // Version of the server software.
    ProtocolRange protocol{};
    std::vector<std::string> profiles{}; // Parts of the protocol offered, which [levels](levels.md) explains; `core` may be left out, for it always is. An operation with `x-profile` is there when its profile is announced. The rules of the profile `crash` are not announced. The kit judges them where it may kill and restart a server of the level Service; a server whose runs do not outlive its process is certified without them and without EVT-009, PUSH-017, REC-123 and REC-124, and its report says that they were not verified. Those of the profile `cluster` are not announced, either. They bind a service that is reached at several base URLs, and the kit judges them where it is given all of these.
    Limits limits{};
    std::vector<std::string> encodings{}; // Media types of the data plane.
    std::vector<std::string> image_codecs{};
    std::string server_time{}; // The server's clock, UTC.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.required("version", self.version);
        visitor.required("protocol", self.protocol);
        visitor.required("profiles", self.profiles);
        visitor.required("limits", self.limits);
        visitor.required("encodings", self.encodings);
        visitor.required("image_codecs", self.image_codecs);
        visitor.required("server_time", self.server_time);
    }
};

/// One of abort, drain.
using StopMode = std::string;

struct StopRun {
    static constexpr char const* schema_name = "StopRun";

    std::optional<StopMode> mode{};
    std::optional<std::string> reason{}; // Why the run is stopped, for people (RSN-004). For the profile `reasons`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.optional("mode", self.mode);
        visitor.optional("reason", self.reason);
    }
};

struct SubmitRun {
    static constexpr char const* schema_name = "SubmitRun";

    std::string benchmark_id{}; // One of `list_benchmarks`.
    PolicyInfo policy{};
    std::optional<std::int32_t> max_workers{}; // Most live workers wanted; the server's limit when absent.
    std::optional<double> idle_timeout_s{}; // Lease of a session; the server's maximum when absent. For the profile `sessions`.
    std::optional<ImageChoice> images{};
    std::optional<CalibrationOptions> options{};
    std::optional<RunMode> mode{};
    std::optional<PolicyServer> policy_server{};
    std::optional<bool> any_policy{}; // Workers may play for another policy than `policy`; false when absent; for the profile `attribution`.
    std::optional<EpisodeSelection> select{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("benchmark_id", self.benchmark_id);
        visitor.required("policy", self.policy);
        visitor.optional("max_workers", self.max_workers);
        visitor.optional("idle_timeout_s", self.idle_timeout_s);
        visitor.optional("images", self.images);
        visitor.optional("options", self.options);
        visitor.optional("mode", self.mode);
        visitor.optional("policy_server", self.policy_server);
        visitor.optional("any_policy", self.any_policy);
        visitor.optional("select", self.select);
    }
};

/// Server time of this turn, in seconds.
struct Timing {
    static constexpr char const* schema_name = "Timing";

    double total_s{}; // The whole turn on the server.
    double queue_s{}; // Waiting for the simulator.
    double simulate_s{}; // Executing actions.
    double render_s{}; // Rendering images.
    double encode_s{}; // Encoding of images.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("total_s", self.total_s);
        visitor.required("queue_s", self.queue_s);
        visitor.required("simulate_s", self.simulate_s);
        visitor.required("render_s", self.render_s);
        visitor.required("encode_s", self.encode_s);
    }
};

/// The answer to attach (turn 0, or in a repeat the latest turn) and to predict.
struct Turn {
    static constexpr char const* schema_name = "Turn";

    std::string session_id{}; // Names the session in every later request.
    std::int64_t seq{}; // Number of the turn.
    std::optional<EpisodeView> episode{};
    std::optional<Observation> observation{};
    std::optional<std::vector<Observation>> observations{}; // With `observe` all, one per executed action.
    std::int32_t executed_steps{}; // How many actions of the chunk were executed.
    bool stopped_early{}; // The episode ended before the chunk did.
    std::vector<double> rewards{}; // One per executed action.
    bool terminated{}; // The task ended by itself in this turn.
    bool truncated{}; // The step limit ended the episode in this turn.
    std::optional<EpisodeResult> episode_result{};
    std::optional<Fault> fault{};
    bool done{}; // No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
    Lease lease{};
    Timing timing{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("session_id", self.session_id);
        visitor.required("seq", self.seq);
        visitor.optional("episode", self.episode);
        visitor.optional("observation", self.observation);
        visitor.optional("observations", self.observations);
        visitor.required("executed_steps", self.executed_steps);
        visitor.required("stopped_early", self.stopped_early);
        visitor.required("rewards", self.rewards);
        visitor.required("terminated", self.terminated);
        visitor.required("truncated", self.truncated);
        visitor.optional("episode_result", self.episode_result);
        visitor.optional("fault", self.fault);
        visitor.required("done", self.done);
        visitor.required("lease", self.lease);
        visitor.required("timing", self.timing);
    }
};

} // namespace proctor
