#include "grader/worker/polygon_view.h"

#include <optional>

#include "grader/cases/local_operation_input.h"
#include "grader/cases/view_input.h"
#include "grader/cases/whole_mesh_input.h"
#include "grader/mesh/dump_mesh.h"
#include "grader/mesh/polygons_of.h"
#include "grader/worker/bench.h"

namespace meshgrade {
namespace {

/// The place of an element among the live ones of its kind; nothing if it is not there.
template <class Record>
std::optional<std::uint32_t> place_among(const std::vector<Record>& records, Ref element) {
  if (element >= records.size() || records[element].live == 0) return {};
  std::uint32_t place = 0;
  for (Ref i = 0; i < element; ++i)
    place += records[i].live == 0 ? 0 : 1;
  return place;
}

std::optional<std::uint32_t> place_of(const MeshDump& mesh, ElementKind kind, Ref element) {
  if (kind == ElementKind::kVertex) return place_among(mesh.vertices, element);
  if (kind == ElementKind::kEdge) return place_among(mesh.edges, element);
  if (kind == ElementKind::kFace) return place_among(mesh.faces, element);
  return {};
}

/// What the exercise of an operation is asked, packed; nothing if an element is not there.
std::optional<std::string> input_of(const ViewOperation& operation, const MeshDump& mesh) {
  if (operation.picked.empty()) return to_wire(WholeMeshInput{});
  LocalOperationInput input;
  for (const Ref element : operation.picked) {
    const auto place = place_of(mesh, operation.picks, element);
    if (!place) return {};
    input.places.push_back(*place);
  }
  return to_wire(input);
}

/// @return false if the mesh is broken
bool build_anew(Bench& bench, const MeshDump& mesh) {
  const auto polygons = polygons_of(mesh);
  if (!polygons) return false;
  try {
    bench.put(*polygons);
  } catch (const meshedit::MeshError&) {
    return false;
  }
  return true;
}

/// While this lives, exercises work on the viewer's mesh.
class AtTheBench {
 public:
  explicit AtTheBench(Bench& bench) { viewers_bench = &bench; }
  AtTheBench(const AtTheBench&) = delete;
  AtTheBench& operator=(const AtTheBench&) = delete;
  ~AtTheBench() { viewers_bench = nullptr; }
};

}  // namespace

void run_polygon_view(WireReader& input, Recorder& recorder, RunExercise run) {
  const auto asked = input.read<ViewInput>();
  Bench bench;
  bench.put(asked.mesh);
  const AtTheBench at_the_bench(bench);
  recorder.set_state_source([&bench] {
    return to_wire(PolygonViewStep{{}, dump_mesh(*bench.mesh)});
  });
  for (std::uint32_t i = 0; i < asked.operations.size(); ++i) {
    const ViewOperation& operation = asked.operations[i];
    const MeshDump before = dump_mesh(*bench.mesh);
    const auto call = input_of(operation, before);
    if (!call) return;
    if (is_built_anew(operation, before) && !build_anew(bench, before)) return;
    PolygonViewStep step;
    Recorder taken([&step](std::string bytes) { step.step = std::move(bytes); });
    WireReader call_input(*call);
    run(operation.exercise, call_input, taken);
    if (i < asked.first_told) continue;
    step.after = dump_mesh(*bench.mesh);
    recorder.add_step(step);
  }
}

}  // namespace meshgrade
