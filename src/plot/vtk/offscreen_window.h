// OffscreenWindow: an OpenGL render window without any display server: an EGL context of Mesa's surfaceless platform,
// and VTK's generic window drawing into it. (Debian's VTK has neither an EGL nor an OSMesa window; its X window aborts
// without a server.)
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <stdexcept>

namespace goniolux::plot {

/// Drawing is not possible on this machine; what() says why.
class CannotDraw : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class OffscreenWindow {
 public:
  /// Throws CannotDraw. Environment variable GONIOLUX_PLOT_NO_GL (any value but empty) makes it throw, for tests.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  vtkGenericOpenGLRenderWindow* window() { return window_; }

 private:
  void makeContext();
  bool makeCurrent() const;

  void *display_ = nullptr, *surface_ = nullptr, *context_ = nullptr;  // EGLDisplay, EGLSurface, EGLContext
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
};

}  // namespace goniolux::plot
