// Transfer functions, lights and the other properties of the volume that are broken.
#include "HostileSession.h"

#include "vtkLight.h"

#include <limits>

namespace volumebench::test
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Property = vtkSmartPointer<vtkVolumeProperty>;

// Of a sound property that `change` breaks.
std::function<void(HostileSession&)> Broken(const std::function<void(vtkVolumeProperty*)>& change)
{
  return [change](HostileSession& session)
  {
    Property property = MakeConstantProperty(0.3);
    change(property);
    session.Show(property);
  };
}

std::function<void(HostileSession&)> WithOpacity(
  const std::vector<std::pair<double, double>>& points)
{
  return Broken(
    [points](vtkVolumeProperty* property)
    {
      vtkNew<vtkPiecewiseFunction> opacity;
      for (const auto& [value, alpha] : points)
      {
        opacity->AddPoint(value, alpha);
      }
      property->SetScalarOpacity(opacity);
    });
}

// Two points of one colour, at values 0 and `second`.
std::function<void(HostileSession&)> WithColor(double red, double second = 4.0)
{
  return Broken(
    [=](vtkVolumeProperty* property)
    {
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(0.0, red, 0.5, 0.5);
      color->AddRGBPoint(second, red, 0.5, 0.5);
      property->SetColor(color);
    });
}

std::function<void(HostileSession&)> WithUnitDistance(double distance)
{
  return Broken(
    [=](vtkVolumeProperty* property) { property->SetScalarOpacityUnitDistance(distance); });
}

// A shaded property that `change` breaks.
std::function<void(HostileSession&)> Shaded(const std::function<void(vtkVolumeProperty*)>& change)
{
  return Broken(
    [change](vtkVolumeProperty* property)
    {
      property->ShadeOn();
      change(property);
    });
}

std::function<void(HostileSession&)> WithGradientOpacity(
  const std::vector<std::pair<double, double>>& points)
{
  return Broken(
    [points](vtkVolumeProperty* property)
    {
      vtkNew<vtkPiecewiseFunction> factor;
      for (const auto& [value, alpha] : points)
      {
        factor->AddPoint(value, alpha);
      }
      property->SetGradientOpacity(factor);
    });
}

std::function<void(HostileSession&)> LitBy(
  int count, const std::function<void(vtkLight*)>& change = [](vtkLight*) {})
{
  return [=](HostileSession& session)
  {
    Shaded([](vtkVolumeProperty*) {})(session);
    for (int i = 0; i < count; ++i)
    {
      vtkNew<vtkLight> light;
      change(light);
      session.Renderer->AddLight(light);
    }
  };
}

Enemies OfOpacity()
{
  return {
    { "opacity_without_points", WithOpacity({}), Refused("the opacity function has no points") },
    { "opacity_of_one_point", WithOpacity({ { 2.0, 0.3 } }), Drawn() },
    { "opacity_at_one_value", WithOpacity({ { 2.0, 0.1 }, { 2.0, 0.5 } }), Drawn() },
    { "opacity_beyond_the_data", WithOpacity({ { 100.0, 0.2 }, { 200.0, 0.3 } }), Drawn() },
    { "opacity_above_one", WithOpacity({ { 0.0, -3.0 }, { 4.0, 7.0 } }), Drawn() },
    { "opacity_nan", WithOpacity({ { 0.0, 0.1 }, { 2.0, NotANumber }, { 4.0, 0.2 } }),
      Refused("the opacity function") },
    { "opacity_infinite", WithOpacity({ { 0.0, 0.1 }, { 4.0, Infinity } }),
      Refused("the opacity function") },
    { "opacity_at_nan", WithOpacity({ { NotANumber, 0.1 }, { 4.0, 0.2 } }),
      Refused("the opacity function") },
    { "opacity_at_infinity", WithOpacity({ { -Infinity, 0.1 }, { 4.0, 0.2 } }),
      Refused("the opacity function") },
    { "opacity_steps_that_touch", WithOpacity({ { 2.0, 0.0 }, { std::nextafter(2.0, 3.0), 0.5 } }),
      Drawn() },
    { "opacity_as_wide_as_doubles",
      WithOpacity({ { -std::numeric_limits<double>::max(), 0.3 },
        { std::numeric_limits<double>::max(), 0.3 } }),
      Drawn() },
    { "unit_distance_zero", WithUnitDistance(0.0), Refused("unit distance is 0") },
    { "unit_distance_negative", WithUnitDistance(-1.0), Refused("unit distance is -1") },
    { "unit_distance_nan", WithUnitDistance(NotANumber), Refused("unit distance is nan") },
    { "unit_distance_infinite", WithUnitDistance(Infinity), Refused("unit distance is inf") },
    { "unit_distance_huge", WithUnitDistance(1e300), Empty() },
    { "unit_distance_tiny", WithUnitDistance(1e-300), Refused("unit distance is 1e-300") },
    { "two_dimensional_function",
      Broken([](vtkVolumeProperty* property)
        { property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D); }),
      Refused("2D transfer functions") },
    { "gradient_opacity_without_points", WithGradientOpacity({}), Drawn() },
    { "gradient_opacity_of_one_point", WithGradientOpacity({ { 0.5, 0.7 } }), Drawn() },
    { "gradient_opacity_nan", WithGradientOpacity({ { 0.0, NotANumber }, { 1.0, 1.0 } }),
      Refused("the gradient opacity function") },
    { "gradient_opacity_at_infinity", WithGradientOpacity({ { 0.0, 0.0 }, { Infinity, 1.0 } }),
      Refused("the gradient opacity function") },
  };
}

Enemies OfColor()
{
  return {
    { "color_without_points",
      Broken([](vtkVolumeProperty* property)
        { property->SetColor(vtkNew<vtkColorTransferFunction>()); }),
      Refused("the colour function has no points") },
    { "color_nan", WithColor(NotANumber), Refused("the colour function") },
    { "color_infinite", WithColor(Infinity), Refused("the colour function") },
    { "color_above_one", WithColor(7.0), Refused("not from 0 to 1: 7") },
    { "color_negative", WithColor(-7.0), Refused("not from 0 to 1: -7") },
    { "color_at_nan", WithColor(0.5, NotANumber), Refused("the colour function") },
    { "color_on_a_logarithm_of_zero",
      Broken(
        [](vtkVolumeProperty* property)
        {
          vtkNew<vtkColorTransferFunction> color;
          color->AddRGBPoint(-1.0, 0.5, 0.5, 0.5);
          color->AddRGBPoint(4.0, 0.5, 0.5, 0.5);
          color->SetScaleToLog10();
          property->SetColor(color);
        }),
      Drawn() },
    { "specular_nan",
      Shaded([](vtkVolumeProperty* property) { property->SetSpecular(NotANumber); }),
      Refused("the specular coefficient is nan") },
    { "ambient_infinite",
      Shaded([](vtkVolumeProperty* property) { property->SetAmbient(Infinity); }),
      Refused("the ambient coefficient is inf") },
    { "diffuse_negative", Shaded([](vtkVolumeProperty* property) { property->SetDiffuse(-1.0); }),
      Refused("the diffuse coefficient is -1") },
    { "specular_power_nan",
      Shaded([](vtkVolumeProperty* property) { property->SetSpecularPower(NotANumber); }),
      Refused("the specular power is nan") },
    { "specular_power_negative",
      Shaded([](vtkVolumeProperty* property) { property->SetSpecularPower(-5.0); }),
      Refused("specular power") },
    { "specular_power_huge",
      Shaded(
        [](vtkVolumeProperty* property)
        {
          property->SetSpecular(1.0);
          property->SetSpecularPower(1e30);
        }),
      Drawn() },
    { "too_many_lights", LitBy(40), Refused("the view has 40 lights") },
    { "light_nowhere", LitBy(1, [](vtkLight* light) { light->SetPosition(NotANumber, 0, 0); }),
      Refused("a light") },
    { "light_without_direction",
      LitBy(1,
        [](vtkLight* light)
        {
          light->SetPosition(1.0, 2.0, 3.0);
          light->SetFocalPoint(1.0, 2.0, 3.0);
        }),
      Refused("a light of the view stands on its focal point") },
    { "light_of_infinite_intensity",
      LitBy(1, [](vtkLight* light) { light->SetIntensity(Infinity); }), Refused("a light") },
    { "light_off", LitBy(3, [](vtkLight* light) { light->SwitchOff(); }), Drawn() },
  };
}
}

Enemies EnemiesOfFunctions()
{
  Enemies all = OfOpacity();
  for (const Enemy& enemy : OfColor())
  {
    all.push_back(enemy);
  }
  return all;
}
}
