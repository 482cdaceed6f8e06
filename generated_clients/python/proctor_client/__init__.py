# coding: utf-8

# flake8: noqa

"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501


__version__ = "0.1.0"

# Define package exports
__all__ = [
    "ControlApi",
    "DataApi",
    "ApiResponse",
    "ApiClient",
    "Configuration",
    "OpenApiException",
    "ApiTypeError",
    "ApiValueError",
    "ApiKeyError",
    "ApiAttributeError",
    "ApiException",
    "Action",
    "Assumption",
    "Assumptions",
    "AttachWorker",
    "Benchmark",
    "BenchmarkList",
    "BenchmarkSummary",
    "BoardEntry",
    "BoardEntryList",
    "CalibrationOptions",
    "CalibrationTask",
    "Checkpoint",
    "ComparedRun",
    "ComparedTask",
    "Comparison",
    "ConsistencyProof",
    "EntryFlag",
    "EntryScore",
    "Episode",
    "EpisodeList",
    "EpisodeResult",
    "EpisodeSelection",
    "EpisodeStatus",
    "EpisodeView",
    "Fault",
    "FlagEntry",
    "GroupScore",
    "Heartbeat",
    "HistoryLeaf",
    "HistoryPage",
    "Image",
    "ImageChoice",
    "ImageSize",
    "ImageSpace",
    "ImportedPolicy",
    "InclusionProof",
    "Interval",
    "KeyList",
    "Lease",
    "Limits",
    "Observation",
    "ObservationSpace",
    "Observe",
    "Outcome",
    "OutcomeCounts",
    "Player",
    "PlayerView",
    "PolicyDescription",
    "PolicyInfo",
    "PolicyProtocol",
    "PolicyReset",
    "PolicyServer",
    "PolicyServerView",
    "Predict",
    "Problem",
    "ProblemItem",
    "Progress",
    "ProtocolRange",
    "PublicKey",
    "PublishEntry",
    "RankInterval",
    "RankedEntry",
    "Ranking",
    "RecordImport",
    "RecordImportList",
    "RecordReplay",
    "ReplayDivergence",
    "ResetPolicy",
    "Run",
    "RunList",
    "RunMode",
    "RunState",
    "Score",
    "SelectionView",
    "Service",
    "SideEffects",
    "SimulatorInfo",
    "StopMode",
    "StopRun",
    "SubmitRun",
    "SuccessRule",
    "Tensor",
    "TensorSpace",
    "Timing",
    "Turn",
    "VectorSpace",
]

# import apis into sdk package
from proctor_client.api.control_api import ControlApi as ControlApi
from proctor_client.api.data_api import DataApi as DataApi

# import ApiClient
from proctor_client.api_response import ApiResponse as ApiResponse
from proctor_client.api_client import ApiClient as ApiClient
from proctor_client.configuration import Configuration as Configuration
from proctor_client.exceptions import OpenApiException as OpenApiException
from proctor_client.exceptions import ApiTypeError as ApiTypeError
from proctor_client.exceptions import ApiValueError as ApiValueError
from proctor_client.exceptions import ApiKeyError as ApiKeyError
from proctor_client.exceptions import ApiAttributeError as ApiAttributeError
from proctor_client.exceptions import ApiException as ApiException

# import models into sdk package
from proctor_client.models.action import Action as Action
from proctor_client.models.assumption import Assumption as Assumption
from proctor_client.models.assumptions import Assumptions as Assumptions
from proctor_client.models.attach_worker import AttachWorker as AttachWorker
from proctor_client.models.benchmark import Benchmark as Benchmark
from proctor_client.models.benchmark_list import BenchmarkList as BenchmarkList
from proctor_client.models.benchmark_summary import BenchmarkSummary as BenchmarkSummary
from proctor_client.models.board_entry import BoardEntry as BoardEntry
from proctor_client.models.board_entry_list import BoardEntryList as BoardEntryList
from proctor_client.models.calibration_options import CalibrationOptions as CalibrationOptions
from proctor_client.models.calibration_task import CalibrationTask as CalibrationTask
from proctor_client.models.checkpoint import Checkpoint as Checkpoint
from proctor_client.models.compared_run import ComparedRun as ComparedRun
from proctor_client.models.compared_task import ComparedTask as ComparedTask
from proctor_client.models.comparison import Comparison as Comparison
from proctor_client.models.consistency_proof import ConsistencyProof as ConsistencyProof
from proctor_client.models.entry_flag import EntryFlag as EntryFlag
from proctor_client.models.entry_score import EntryScore as EntryScore
from proctor_client.models.episode import Episode as Episode
from proctor_client.models.episode_list import EpisodeList as EpisodeList
from proctor_client.models.episode_result import EpisodeResult as EpisodeResult
from proctor_client.models.episode_selection import EpisodeSelection as EpisodeSelection
from proctor_client.models.episode_status import EpisodeStatus as EpisodeStatus
from proctor_client.models.episode_view import EpisodeView as EpisodeView
from proctor_client.models.fault import Fault as Fault
from proctor_client.models.flag_entry import FlagEntry as FlagEntry
from proctor_client.models.group_score import GroupScore as GroupScore
from proctor_client.models.heartbeat import Heartbeat as Heartbeat
from proctor_client.models.history_leaf import HistoryLeaf as HistoryLeaf
from proctor_client.models.history_page import HistoryPage as HistoryPage
from proctor_client.models.image import Image as Image
from proctor_client.models.image_choice import ImageChoice as ImageChoice
from proctor_client.models.image_size import ImageSize as ImageSize
from proctor_client.models.image_space import ImageSpace as ImageSpace
from proctor_client.models.imported_policy import ImportedPolicy as ImportedPolicy
from proctor_client.models.inclusion_proof import InclusionProof as InclusionProof
from proctor_client.models.interval import Interval as Interval
from proctor_client.models.key_list import KeyList as KeyList
from proctor_client.models.lease import Lease as Lease
from proctor_client.models.limits import Limits as Limits
from proctor_client.models.observation import Observation as Observation
from proctor_client.models.observation_space import ObservationSpace as ObservationSpace
from proctor_client.models.observe import Observe as Observe
from proctor_client.models.outcome import Outcome as Outcome
from proctor_client.models.outcome_counts import OutcomeCounts as OutcomeCounts
from proctor_client.models.player import Player as Player
from proctor_client.models.player_view import PlayerView as PlayerView
from proctor_client.models.policy_description import PolicyDescription as PolicyDescription
from proctor_client.models.policy_info import PolicyInfo as PolicyInfo
from proctor_client.models.policy_protocol import PolicyProtocol as PolicyProtocol
from proctor_client.models.policy_reset import PolicyReset as PolicyReset
from proctor_client.models.policy_server import PolicyServer as PolicyServer
from proctor_client.models.policy_server_view import PolicyServerView as PolicyServerView
from proctor_client.models.predict import Predict as Predict
from proctor_client.models.problem import Problem as Problem
from proctor_client.models.problem_item import ProblemItem as ProblemItem
from proctor_client.models.progress import Progress as Progress
from proctor_client.models.protocol_range import ProtocolRange as ProtocolRange
from proctor_client.models.public_key import PublicKey as PublicKey
from proctor_client.models.publish_entry import PublishEntry as PublishEntry
from proctor_client.models.rank_interval import RankInterval as RankInterval
from proctor_client.models.ranked_entry import RankedEntry as RankedEntry
from proctor_client.models.ranking import Ranking as Ranking
from proctor_client.models.record_import import RecordImport as RecordImport
from proctor_client.models.record_import_list import RecordImportList as RecordImportList
from proctor_client.models.record_replay import RecordReplay as RecordReplay
from proctor_client.models.replay_divergence import ReplayDivergence as ReplayDivergence
from proctor_client.models.reset_policy import ResetPolicy as ResetPolicy
from proctor_client.models.run import Run as Run
from proctor_client.models.run_list import RunList as RunList
from proctor_client.models.run_mode import RunMode as RunMode
from proctor_client.models.run_state import RunState as RunState
from proctor_client.models.score import Score as Score
from proctor_client.models.selection_view import SelectionView as SelectionView
from proctor_client.models.service import Service as Service
from proctor_client.models.side_effects import SideEffects as SideEffects
from proctor_client.models.simulator_info import SimulatorInfo as SimulatorInfo
from proctor_client.models.stop_mode import StopMode as StopMode
from proctor_client.models.stop_run import StopRun as StopRun
from proctor_client.models.submit_run import SubmitRun as SubmitRun
from proctor_client.models.success_rule import SuccessRule as SuccessRule
from proctor_client.models.tensor import Tensor as Tensor
from proctor_client.models.tensor_space import TensorSpace as TensorSpace
from proctor_client.models.timing import Timing as Timing
from proctor_client.models.turn import Turn as Turn
from proctor_client.models.vector_space import VectorSpace as VectorSpace
