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
/// Surfaces coloured by their cells, lit.
void makeSurface(vtkActor& actor, bool insideOnly);
/// One colour, not lit.
void makePlain(vtkActor& actor, const QColor& colour, float width = 1);
void setData(vtkActor& actor, vtkPolyData* data);

vtkSmartPointer<vtkPolyData> openingsOf(const RoomScene& scene);
vtkSmartPointer<vtkPolyData> rimsOf(const RoomScene& scene, const std::string& only = {});
/// Lines from each luminaire along its aim to what they meet, at most.
vtkSmartPointer<vtkPolyData> aimsOf(const RoomScene& scene);
/// The outline of the box around the objects of an entry of the document.
vtkSmartPointer<vtkPolyData> boxAround(const RoomScene& scene, const std::string& pointer);
vtkSmartPointer<vtkPolyData> lineBetween(const core::Vec3& from, const core::Vec3& to);

}  // namespace goniolux::gui
