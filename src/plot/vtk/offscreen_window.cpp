#include "plot/vtk/offscreen_window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>
#include <vtkCommand.h>

#include <cstdlib>
#include <functional>
#include <utility>

namespace goniolux::plot {
namespace {

/// A VTK observer that calls a function with the event's data.
class Answer final : public vtkCommand {
 public:
  static Answer* New() { return new Answer; }
  void Execute(vtkObject*, unsigned long, void* data) override {
    if (function) function(data);
  }
  std::function<void(void*)> function;
};

void answer(vtkObject* window, unsigned long event, std::function<void(void*)> function) {
  vtkNew<Answer> command;
  command->function = std::move(function);
  window->AddObserver(event, command);
}

}  // namespace

OffscreenWindow::OffscreenWindow(int width, int height) {
  if (const char* off = std::getenv("GONIOLUX_PLOT_NO_GL"); off != nullptr && *off != '\0') {
    throw CannotDraw("OpenGL is switched off by GONIOLUX_PLOT_NO_GL");
  }
  makeContext();
  answer(window_, vtkCommand::WindowMakeCurrentEvent, [this](void*) { makeCurrent(); });
  answer(window_, vtkCommand::WindowIsCurrentEvent,
         [this](void* data) { *static_cast<bool*>(data) = eglGetCurrentContext() == context_; });
  answer(window_, vtkCommand::WindowSupportsOpenGLEvent, [](void* data) { *static_cast<int*>(data) = 1; });
  answer(window_, vtkCommand::WindowIsDirectEvent, [](void* data) { *static_cast<int*>(data) = 1; });
  // GLEW asks for an X display and reports "Unknown error" in each Render(); its function pointers are there all the
  // same.
  answer(window_, vtkCommand::ErrorEvent, {});
  window_->SetReadyForRendering(true);
  window_->SetOwnContext(false);
  window_->SetOffScreenRendering(1);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetMultiSamples(4);
  window_->SetDPI(72);  // a font's size in points is its size in pixels
  window_->SetSize(width, height);
}

OffscreenWindow::~OffscreenWindow() {
  window_->Finalize();
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglDestroySurface(display_, surface_);
  eglTerminate(display_);
}

bool OffscreenWindow::makeCurrent() const {
  return eglMakeCurrent(display_, surface_, surface_, context_) == EGL_TRUE;
}

void OffscreenWindow::makeContext() {
  const auto fail = [](const char* step) {
    throw CannotDraw(
        fmt::format("no OpenGL without a display ({} failed, EGL error 0x{:x}); install the packages libegl1 and "
                    "libgl1-mesa-dri",
                    step, eglGetError()));
  };
  const auto getPlatformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (!getPlatformDisplay) fail("eglGetPlatformDisplayEXT");
  display_ = getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display_ == EGL_NO_DISPLAY) fail("eglGetPlatformDisplay");
  if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) fail("eglInitialize");
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("eglBindAPI");

  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglChooseConfig(display_, wanted, &config, 1, &found) == EGL_FALSE || found < 1) fail("eglChooseConfig");
  // VTK draws into framebuffers of its own; the surface only has to exist.
  const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
  surface_ = eglCreatePbufferSurface(display_, config, size);
  if (surface_ == EGL_NO_SURFACE) fail("eglCreatePbufferSurface");
  const EGLint version[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
  if (context_ == EGL_NO_CONTEXT) fail("eglCreateContext");
  if (!makeCurrent()) fail("eglMakeCurrent");
}

}  // namespace goniolux::plot
