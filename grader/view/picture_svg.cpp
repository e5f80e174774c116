#include "grader/view/picture_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "grader/base/text.h"
#include "grader/report/projection.h"
#include "grader/view/deviation_scale.h"

namespace meshgrade {
namespace {

constexpr double kCaption = 30.0;
constexpr double kLegend = 46.0;
constexpr double kFieldOfView = 38.0;  // of the page's camera, so that both pictures agree
constexpr std::size_t kMostLabelled = 400;

/// The same as in the page's style sheet.
struct Theme {
  const char* ground;
  const char* ink;
  const char* line;
  const char* wrong;
  const char* back;   ///< of faces seen from behind
  const char* dim;    ///< of faces that get no light
  const char* light;  ///< of faces that get all
  const char* normal;
};
constexpr Theme kLight{"#fbfcfd", "#2a3440", "#4a5560", "#c03a00",
                       "#b9a892", "#8796a8", "#dde6f0", "#0a5ca8"};
constexpr Theme kDark{"#171b20", "#dfe5eb", "#b4bec9", "#ff8f5a",
                      "#5d4b3a", "#2c343e", "#75859a", "#7fbcf5"};

/// The vertices of a face whose walk closes; empty if it does not.
/// @param most  half-edges after which it does not
std::vector<Ref> corners_of(const MeshDump& mesh, const FaceRecord& face, std::size_t most) {
  std::vector<Ref> corners;
  Ref h = face.halfedge;
  while (h < mesh.halfedges.size() && corners.size() < most) {
    const HalfedgeRecord& record = mesh.halfedges[h];
    if (record.live == 0 || record.vertex >= mesh.vertices.size()) return {};
    corners.push_back(record.vertex);
    h = record.next;
    if (h == face.halfedge) return corners.size() >= 3 ? corners : std::vector<Ref>{};
  }
  return {};
}

/// How far to walk around each face. By how many half-edges lie in it, so that in a broken
/// mesh, too, all walks together are linear in its size.
std::vector<std::size_t> walk_limits(const MeshDump& mesh) {
  std::vector<std::size_t> limits(mesh.faces.size(), 4);
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (h.live != 0 && h.face < limits.size()) limits[h.face] += 2;
  }
  return limits;
}

using Ends = std::pair<Ref, Ref>;

/// The two ends of a half-edge, by its twin.
bool find_ends(const MeshDump& mesh, const HalfedgeRecord& h, Ends& ends) {
  if (h.live == 0 || h.twin >= mesh.halfedges.size()) return false;
  ends = std::minmax(h.vertex, mesh.halfedges[h.twin].vertex);
  return ends.first != ends.second && ends.second < mesh.vertices.size();
}

/// Something to draw: a face, or a line that no face has as a side.
struct Shape {
  std::vector<Ref> corners;
  Ref face = kUnsetRef;
};

std::vector<Shape> shapes_of(const MeshDump& mesh) {
  std::vector<Shape> shapes;
  std::set<Ends> sides;
  const std::vector<std::size_t> limits = walk_limits(mesh);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.faces[f].live == 0) continue;
    Shape shape{corners_of(mesh, mesh.faces[f], limits[f]), static_cast<Ref>(f)};
    for (std::size_t i = 0; i < shape.corners.size(); ++i)
      sides.insert(
          std::minmax(shape.corners[i], shape.corners[(i + 1) % shape.corners.size()]));
    if (!shape.corners.empty()) shapes.push_back(std::move(shape));
  }
  Ends ends;
  for (const HalfedgeRecord& h : mesh.halfedges) {
    if (find_ends(mesh, h, ends) && sides.insert(ends).second)
      shapes.push_back({{ends.first, ends.second}, kUnsetRef});
  }
  return shapes;
}

/// The box around all live vertices, as its middle and half its diagonal.
struct Ball {
  Point3 centre{0.0, 0.0, 0.0};
  double radius = 1.0;
};

Ball ball_of(const MeshDump& mesh) {
  Point3 low{INFINITY, INFINITY, INFINITY};
  Point3 high{-INFINITY, -INFINITY, -INFINITY};
  for (const VertexRecord& v : mesh.vertices) {
    if (v.live == 0 || !is_finite(vector_of(v.position))) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], v.position[axis]);
      high[axis] = std::max(high[axis], v.position[axis]);
    }
  }
  Ball ball;
  if (!(low[0] <= high[0])) return ball;
  for (std::size_t axis = 0; axis < 3; ++axis)
    ball.centre[axis] = 0.5 * (low[axis] + high[axis]);
  const double diagonal = (vector_of(high) - vector_of(low)).norm();
  if (diagonal > 0.0) ball.radius = 0.5 * diagonal;
  return ball;
}

Projection projection_of(const Camera& camera, bool z_up) {
  const double radians = std::numbers::pi / 180.0;
  const double azimuth = camera.azimuth * radians;
  // Straight from above or below, up would be lost.
  const double elevation = std::clamp(camera.elevation, -89.9, 89.9) * radians;
  const double right = std::sin(azimuth) * std::cos(elevation);
  const double front = std::cos(azimuth) * std::cos(elevation);
  if (z_up) return {{right, -front, std::sin(elevation)}, {0.0, 0.0, 1.0}};
  return {{right, std::sin(elevation), front}, {0.0, 1.0, 0.0}};
}

/// Up and to the left of the eye.
Camera lamp_beside(const Camera& eye) {
  return {eye.azimuth - 28.0, eye.elevation + 28.0, eye.distance};
}

/// One mesh in its box.
class Painter {
 public:
  Painter(const SvgPen& pen, const PicturePanel& panel, const PictureRequest& request,
          const Ball& ball, const Box& box)
      : pen_(pen),
        mesh_(panel.mesh),
        deviation_(panel.deviation),
        request_(request),
        theme_(request.dark ? kDark : kLight),
        normals_(panel.normals),
        radius_(ball.radius),
        view_(projection_of(request.camera, request.z_up)),
        light_(projection_of(lamp_beside(request.camera), request.z_up)),
        middle_{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)},
        centre_(view_.on_screen(ball.centre)) {
    const double seen = ball.radius * request.camera.distance *
                        std::tan(0.5 * kFieldOfView * std::numbers::pi / 180.0);
    scale_ = 0.5 * std::min(box.x1 - box.x0, box.y1 - box.y0) / seen;
  }

  void paint() const {
    const std::vector<Shape> shapes = shapes_of(mesh_);
    std::vector<double> depths;
    for (const Shape& shape : shapes)
      depths.push_back(view_.depth(middle_of(shape)));
    const SvgPen faces = pen_.group("faces");
    for (const std::size_t i : far_to_near(depths))
      paint_shape(faces, shapes[i]);
    if (request_.normals) paint_normals();
    if (request_.compare && !deviation_.empty()) mark_worst();
    if (request_.ids && mesh_.halfedges.size() <= kMostLabelled) paint_ids(shapes);
  }

 private:
  Spot spot(const Point3& p) const {
    const Spot s = scale_ * (view_.on_screen(p) - centre_);
    return std::isfinite(s.x) && std::isfinite(s.y) ? middle_ + s : middle_;
  }
  const Point3& place(Ref v) const { return mesh_.vertices[v].position; }

  Point3 middle_of(const Shape& shape) const {
    Point3 sum{0.0, 0.0, 0.0};
    for (const Ref v : shape.corners) {
      for (std::size_t axis = 0; axis < 3; ++axis)
        sum[axis] += place(v)[axis] / static_cast<double>(shape.corners.size());
    }
    return sum;
  }

  double facing(const Projection& from, const Shape& shape) const {
    return from.facing(place(shape.corners[0]), place(shape.corners[1]),
                       place(shape.corners[2]));
  }

  std::string fill_of(const Shape& shape) const {
    if (request_.wireframe) return "none";
    if (request_.compare && !deviation_.empty()) {
      // Its worst vertex: a mean would hide the one that sticks out.
      double worst = 0.0;
      for (const Ref v : shape.corners)
        worst = std::max(worst, deviation_.of_vertex[v]);
      return deviation_color(deviation_, worst);
    }
    if (facing(view_, shape) < 0.0) return theme_.back;
    return mixed_color(theme_.dim, theme_.light, std::max(0.0, facing(light_, shape)));
  }

  bool has_normal(Ref v) const {
    return v < normals_.size() && is_finite(vector_of(normals_[v]));
  }

  bool is_smooth(const Shape& shape) const {
    return request_.smooth && !request_.wireframe && shape.corners.size() == 3 &&
           std::all_of(shape.corners.begin(), shape.corners.end(),
                       [&](Ref v) { return has_normal(v); });
  }

  /// So many pieces along each side that the picture stays small.
  int pieces() const {
    constexpr double kMostPieces = 6000.0;
    const auto faces = static_cast<double>(std::max<std::size_t>(1, mesh_.faces.size()));
    return static_cast<int>(std::clamp(std::sqrt(kMostPieces / faces), 1.0, 8.0));
  }

  /// Phong's shading: the normal is interpolated, and each piece gets its own light.
  void paint_smooth(const SvgPen& pen, const Shape& shape) const {
    const int n = pieces();
    const auto mixed = [&](double i, double j, auto of) {
      const double a = i / n;
      const double b = j / n;
      return (1.0 - a - b) * of(shape.corners[0]) + a * of(shape.corners[1]) +
             b * of(shape.corners[2]);
    };
    const auto at = [&](double i, double j) {
      return mixed(i, j, [&](Ref v) { return spot(place(v)); });
    };
    const auto piece = [&](Spot p, Spot q, Spot r, double i, double j) {
      const meshedit::Vector3D normal =
          mixed(i, j, [&](Ref v) { return vector_of(normals_[v]); }).unit();
      const double light = std::max(0.0, dot(normal, light_.towards()));
      const std::string color = dot(normal, view_.towards()) < 0.0
                                    ? std::string(theme_.back)
                                    : mixed_color(theme_.dim, theme_.light, light);
      pen.polygon({p, q, r}, color.c_str(), {color.c_str(), 0.6});
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        piece(at(i, j), at(i + 1, j), at(i, j + 1), i + 0.33, j + 0.33);
        if (i + j + 1 < n)
          piece(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), i + 0.67, j + 0.67);
      }
    }
  }

  void paint_normals() const {
    const SvgPen group = pen_.group("normals");
    for (std::size_t v = 0; v < normals_.size() && v < mesh_.vertices.size(); ++v) {
      const auto vertex = static_cast<Ref>(v);
      if (mesh_.vertices[v].live == 0 || !has_normal(vertex)) continue;
      const meshedit::Vector3D normal = vector_of(normals_[v]);
      if (!request_.wireframe && dot(normal, view_.towards()) < -0.3) continue;
      const meshedit::Vector3D tip = vector_of(place(vertex)) + 0.15 * radius_ * normal;
      group.line(spot(place(vertex)), spot({tip.x, tip.y, tip.z}), {theme_.normal, 1.6});
    }
  }

  void paint_shape(const SvgPen& pen, const Shape& shape) const {
    if (is_smooth(shape)) {
      paint_smooth(pen, shape);
      return;
    }
    std::vector<Spot> spots;
    for (const Ref v : shape.corners)
      spots.push_back(spot(place(v)));
    const Stroke stroke{theme_.line, 0.9};
    if (spots.size() == 2) {
      pen.line(spots[0], spots[1], {theme_.wrong, 1.6});
    } else {
      pen.polygon(spots, fill_of(shape).c_str(), stroke);
    }
  }

  void mark_worst() const {
    const SvgPen group = pen_.group("worst");
    for (const Ref v : shown_worst(deviation_)) {
      const Spot at = spot(place(v));
      group.circle(at, 6.0, "none", {theme_.wrong, 2.0});
      label(group, at + Spot{0.0, -15.0}, vertex_name(v), theme_.wrong);
    }
  }

  void label(const SvgPen& pen, Spot at, const std::string& text, const char* ground) const {
    constexpr double kSize = 13.0;
    pen.box(box_around(at, text_width(text, kSize) + 6.0, 16.5), 3.0, ground, {});
    pen.text(at, text, {kSize, ground == theme_.ground ? theme_.ink : theme_.ground});
  }

  /// Of what faces the eye; of all, if the mesh has holes to look through.
  void paint_ids(const std::vector<Shape>& shapes) const {
    const bool open = request_.wireframe || !mesh_.boundaries.empty();
    std::set<Ref> vertices;
    std::set<Ends> seen;
    const SvgPen group = pen_.group("ids");
    for (const Shape& shape : shapes) {
      if (shape.corners.size() < 3 || (!open && facing(view_, shape) <= 0.0)) continue;
      pen_.group("face-id").text(spot(middle_of(shape)), face_name(shape.face),
                                 {13.0, theme_.ink});
      vertices.insert(shape.corners.begin(), shape.corners.end());
      for (std::size_t i = 0; i < shape.corners.size(); ++i)
        seen.insert(
            std::minmax(shape.corners[i], shape.corners[(i + 1) % shape.corners.size()]));
    }
    Ends ends;
    for (const HalfedgeRecord& h : mesh_.halfedges) {
      if (!find_ends(mesh_, h, ends) || seen.erase(ends) == 0) continue;
      label(group, 0.5 * (spot(place(ends.first)) + spot(place(ends.second))),
            edge_name(h.edge), theme_.ground);
    }
    for (const Ref v : vertices)
      label(group, spot(place(v)), vertex_name(v), theme_.ink);
  }

  SvgPen pen_;
  const MeshDump& mesh_;
  const Deviation& deviation_;
  const PictureRequest& request_;
  const Theme& theme_;
  const std::vector<Point3>& normals_;
  double radius_;
  Projection view_;
  Projection light_;
  Spot middle_;
  Spot centre_;
  double scale_ = 1.0;
};

/// Broken between words; what does not fit into the second line is cut off.
std::pair<std::string, std::string> in_two_lines(const std::string& text, std::size_t letters) {
  if (text.size() <= letters) return {text, ""};
  const std::size_t gap = text.rfind(' ', letters);
  if (gap == std::string::npos) return {shortened(text, letters), ""};
  return {text.substr(0, gap), shortened(text.substr(gap + 1), letters)};
}

void draw_legend(const SvgPen& pen, const Deviation& deviation, const PictureRequest& request) {
  const Theme& theme = request.dark ? kDark : kLight;
  constexpr int kSteps = 40;
  constexpr double kWidth = 200.0;
  const double top = request.size.height - kLegend + 8.0;
  const SvgPen group = pen.group("legend");
  for (int i = 0; i < kSteps; ++i) {
    const double x = 14.0 + kWidth * i / kSteps;
    const double part = deviation_range(deviation) * (i + 0.5) / kSteps;
    group.box({x, top, x + kWidth / kSteps + 0.5, top + 12.0}, 0.0,
              deviation_color(deviation, part).c_str(), {});
  }
  const std::array<std::string, 2> ends = deviation_ends(deviation);
  Lettering small{13.0, theme.ink, false, Anchor::kStart, false};
  group.text({14.0, top + 22.0}, ends[0], small);
  const auto letters = static_cast<std::size_t>((request.size.width - kWidth - 40.0) /
                                                text_width("m", small.size));
  const auto [first, second] = in_two_lines(deviation_text(deviation), letters);
  group.text({kWidth + 28.0, top + 6.0}, first, small);
  group.text({kWidth + 28.0, top + 22.0}, second, small);
  small.anchor = Anchor::kEnd;
  group.text({14.0 + kWidth, top + 22.0}, ends[1], small);
}

/// How many panels stand beside each other, so that they come out as large as possible.
std::size_t best_columns(std::size_t count, PictureSize size) {
  std::size_t best = 1;
  double largest = 0.0;
  for (std::size_t columns = 1; columns <= count; ++columns) {
    const std::size_t rows = (count + columns - 1) / columns;
    const double side = std::min(size.width / static_cast<double>(columns),
                                 size.height / static_cast<double>(rows) - kCaption);
    if (side > largest) {
      largest = side;
      best = columns;
    }
  }
  return best;
}

void draw(const SvgPen& pen, const std::vector<PicturePanel>& panels,
          const PictureRequest& request) {
  const Theme& theme = request.dark ? kDark : kLight;
  const double width = request.size.width;
  pen.box({0.0, 0.0, width, static_cast<double>(request.size.height)}, 0.0, theme.ground, {});
  const Deviation& last = panels.back().deviation;
  const bool legend = request.compare && !last.empty();
  const double height = request.size.height - (legend ? kLegend : 0.0);
  const std::size_t columns = best_columns(panels.size(), request.size);
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  const Ball ball = ball_of(panels[0].mesh);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double w = width / static_cast<double>(columns);
    const double h = height / static_cast<double>(rows);
    const std::size_t row = i / columns;
    const Spot corner{w * static_cast<double>(i % columns), h * static_cast<double>(row)};
    const double head = panels[i].caption.empty() ? 0.0 : kCaption;
    if (head > 0.0) {
      pen.text(corner + Spot{0.5 * w, 17.0}, panels[i].caption,
               {15.0, theme.ink, false, Anchor::kMiddle, false});
    }
    const Box box{corner.x, corner.y + head, corner.x + w, corner.y + h};
    Painter(pen.clipped_group("mesh", box), panels[i], request, ball, box).paint();
  }
  if (legend) draw_legend(pen, last, request);
}

}  // namespace

std::string picture_svg(const std::vector<PicturePanel>& panels, const PictureRequest& request,
                        const std::string& title, const std::string& description) {
  return svg_document("meshgrade-picture", "picture", title, description,
                      [&](pugi::xml_node svg) {
                        draw(SvgPen(svg), panels, request);
                        return Spot{static_cast<double>(request.size.width),
                                    static_cast<double>(request.size.height)};
                      });
}

}  // namespace meshgrade
