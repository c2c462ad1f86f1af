// Asks a window that a user sits in front of for another frame, as soon as nothing happens in it.
#ifndef volumebench_FrameRequest_h
#define volumebench_FrameRequest_h

#include <memory>

class vtkRenderWindow;

namespace volumebench
{
class FrameRequest
{
public:
  FrameRequest() = default;
  ~FrameRequest() { this->Cancel(); }
  FrameRequest(const FrameRequest&) = delete;
  FrameRequest& operator=(const FrameRequest&) = delete;

  /// Whether frames of the window are shown, and Qt's event loop runs its timers. Screenshots,
  /// scripts, batches and servers have no such window.
  static bool IsPossible(vtkRenderWindow* window);

  /// In place of what was asked for before.
  void Ask(vtkRenderWindow* window);
  void Cancel();

  /// Whether the frame that is drawn now is the one asked for.
  bool IsDue() const;

private:
  struct Timer;
  std::shared_ptr<Timer> Pending; // null when nothing was asked for
};
}

#endif
