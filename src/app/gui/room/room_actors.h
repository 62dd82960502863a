// The actors of the 3-D view: VTK data with its look.
#pragma once

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <string>

#include "app/gui/room/room_scene.h"

namespace goniolux::gui {

/// An actor of its own mapper without data.
vtkSmartPointer<vtkActor> emptyActor();
/// Surfaces coloured by their points, lit; `frontOnly`: their backs are not drawn.
void makeSurface(vtkActor& actor, bool frontOnly);
/// Lines that go before the surfaces that they bound.
void makeForward(vtkActor& actor);
/// How far lines come forward, in depth of the clip space; to be set before each picture.
void drawForward(vtkActor& actor, double depth);
/// One colour, not lit.
void makePlain(vtkActor& actor, const QColor& colour, float width = 1);
void setData(vtkActor& actor, vtkPolyData* data);

vtkSmartPointer<vtkPolyData> openingsOf(const RoomScene& scene);
vtkSmartPointer<vtkPolyData> rimsOf(const RoomScene& scene);
/// Lines from each luminaire along its aim to what they meet, at most.
vtkSmartPointer<vtkPolyData> aimsOf(const RoomScene& scene);
/// What is selected: rims of luminaires and boxes around objects.
vtkSmartPointer<vtkPolyData> marksOf(const RoomScene& scene, const std::vector<std::string>& pointers);
/// The photometric solids of selected luminaires as nets of lines: in every direction as far as the intensity says, the
/// strongest as far as the aiming lines reach. Of many luminaires the first ones.
vtkSmartPointer<vtkPolyData> solidsOf(const RoomScene& scene, const std::vector<std::string>& pointers);
vtkSmartPointer<vtkPolyData> lineBetween(const core::Vec3& from, const core::Vec3& to);

}  // namespace goniolux::gui
