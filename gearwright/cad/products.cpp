#include "gearwright/cad/products.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/brep.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright {
namespace {

using Id = Part21Id;

// Converts a linear value to sRGB, the colour space of STEP. Three decimals are finer than the 256
// levels of a display.
double srgb(double linear) {
  const double value =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return std::round(1000.0 * value) / 1000.0;
}

class ProductWriter {
 public:
  ProductWriter(Part21& out, const StepProtocol& protocol) : out_(out) {
    const Id application = add("APPLICATION_CONTEXT('{}')", protocol.context);
    add("APPLICATION_PROTOCOL_DEFINITION('international standard','{}',{},#{})", protocol.name,
        protocol.year, application);
    product_context_ = add("PRODUCT_CONTEXT('',#{},'mechanical')", application);
    definition_context_ =
        add("PRODUCT_DEFINITION_CONTEXT('part definition',#{},'design')", application);
    mm_ = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    rad_ = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    sr_ = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    std::string uncertainty = "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(";
    append_real(uncertainty, kBrepUncertainty_mm);
    uncertainty_ = out_.add(uncertainty + fmt::format("),#{},'distance_accuracy_value','points, "
                                                      "edges and faces agree within')",
                                                      mm_));
    origin_ = placement({});
  }

  struct Product {
    Id definition;
    Id shape;  // the representation of the shape
  };

  Product part(const std::string& name, Id solid, const std::array<double, 3>& colour) {
    const Id context = representation_context(name);
    const Id shape = add("ADVANCED_BREP_SHAPE_REPRESENTATION({},(#{},#{}),#{})",
                         part21_string(name), origin_, solid, context);
    colour_solid(solid, colour, context);
    return product(name, shape);
  }

  void assembly(const std::string& name, const std::vector<ToothedBody>& bodies,
                const std::vector<Product>& products) {
    std::vector<Id> items{origin_};
    for (const ToothedBody& body : bodies) items.push_back(placement(body.pose));
    std::string text = fmt::format("SHAPE_REPRESENTATION({},", part21_string(name));
    append_ids(text, items);
    const Id context = representation_context(name);
    const Product whole = product(name, out_.add(text + fmt::format(",#{})", context)));
    for (std::size_t i = 0; i < bodies.size(); ++i)
      component(i + 1, bodies[i].name, whole, products[i], items[i + 1]);
  }

 private:
  template <class... Args>
  Id add(fmt::format_string<Args...> text, Args&&... args) {
    return out_.add(fmt::format(text, std::forward<Args>(args)...));
  }

  Id placement(const SolidPose& pose) {
    const Id origin = out_.point(pose.origin());
    const Id z = out_.direction(pose.axis(2));
    return out_.placement(origin, z, out_.direction(pose.axis(0)));
  }

  // Every representation has its own context. A relationship with a transformation can connect only
  // representations with different contexts.
  Id representation_context(const std::string& name) {
    return add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{}))"
        "GLOBAL_UNIT_ASSIGNED_CONTEXT((#{},#{},#{}))REPRESENTATION_CONTEXT({},'3D'))",
        uncertainty_, mm_, rad_, sr_, part21_string(name));
  }

  Product product(const std::string& name, Id shape) {
    const std::string text = part21_string(name);
    const Id product = add("PRODUCT({},{},'',(#{}))", text, text, product_context_);
    add("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#{}))", product);
    const Id formation = add("PRODUCT_DEFINITION_FORMATION('','',#{})", product);
    const Id definition =
        add("PRODUCT_DEFINITION('design','',#{},#{})", formation, definition_context_);
    const Id definition_shape = add("PRODUCT_DEFINITION_SHAPE('','',#{})", definition);
    add("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", definition_shape, shape);
    return {definition, shape};
  }

  void component(std::size_t number, const std::string& name, const Product& whole,
                 const Product& part, Id place) {
    const Id move = add("ITEM_DEFINED_TRANSFORMATION('','',#{},#{})", origin_, place);
    const Id relation = add(
        "(REPRESENTATION_RELATIONSHIP('','',#{},#{})"
        "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{})SHAPE_REPRESENTATION_RELATIONSHIP())",
        part.shape, whole.shape, move);
    const Id usage = add("NEXT_ASSEMBLY_USAGE_OCCURRENCE('{}',{},'',#{},#{},$)", number,
                         part21_string(name), whole.definition, part.definition);
    const Id placed =
        add("PRODUCT_DEFINITION_SHAPE('Placement','Placement of an item',#{})", usage);
    add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{},#{})", relation, placed);
  }

  void colour_solid(Id solid, const std::array<double, 3>& linear, Id context) {
    std::string rgb = "COLOUR_RGB(''";
    for (const double value : linear) {
      rgb += ',';
      append_real(rgb, srgb(value));
    }
    Id style = out_.add(rgb + ")");
    style = add("FILL_AREA_STYLE_COLOUR('',#{})", style);
    style = add("FILL_AREA_STYLE('',(#{}))", style);
    style = add("SURFACE_STYLE_FILL_AREA(#{})", style);
    style = add("SURFACE_SIDE_STYLE('',(#{}))", style);
    style = add("SURFACE_STYLE_USAGE(.BOTH.,#{})", style);
    style = add("PRESENTATION_STYLE_ASSIGNMENT((#{}))", style);
    const Id item = add("STYLED_ITEM('colour',(#{}),#{})", style, solid);
    add("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#{}),#{})", item, context);
  }

  Part21& out_;
  Id product_context_ = 0;
  Id definition_context_ = 0;
  Id mm_ = 0;
  Id rad_ = 0;
  Id sr_ = 0;
  Id uncertainty_ = 0;
  Id origin_ = 0;
};

}  // namespace

void add_products(Part21& out, const StepProtocol& protocol, const std::vector<ToothedBody>& bodies,
                  const std::vector<Part21Id>& solids, const std::string& assembly) {
  GW_EXPECTS(!bodies.empty());
  ProductWriter writer(out, protocol);
  std::vector<ProductWriter::Product> products;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    products.push_back(bodies[i].same_as ? products[*bodies[i].same_as]
                                         : writer.part(bodies[i].name, solids[i],
                                                       part_colour(bodies[i].colour.value_or(i))));
  if (bodies.size() > 1 || !bodies[0].pose.is_identity())
    writer.assembly(assembly, bodies, products);
}

}  // namespace gearwright
