// A question about the still picture that a view shows. It is answered on request, by drawing the
// picture again beside the window, and the answer holds until the picture, or a setting that it
// depends on, is another.
#ifndef volumebench_PictureQuestion_h
#define volumebench_PictureQuestion_h

#include "VolumePainter.h"

#include "vtkRenderer.h"
#include "vtkType.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkVolumeBenchMapper;

namespace volumebench
{
class PictureQuestion
{
public:
  /// It is asked of the next still picture.
  void Request();

  /// To be called after each frame; `failure` says why it was not drawn. Answers when that is asked
  /// for and the frame is no interactive one.
  void FollowFrame(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    VolumePainter& painter, const std::string& failure);

protected:
  /// `refusal` begins the text that says why there is no answer, such as "not counted".
  explicit PictureQuestion(const char* refusal);
  ~PictureQuestion() = default;

  /// Draws off-screen and keeps what it finds. Throws what says why it cannot.
  virtual void Answer(vtkVolumeBenchMapper* mapper, vtkRenderer* renderer, vtkVolume* volume,
    VolumePainter& painter) = 0;

  /// Whether there has been an answer, to the last request.
  bool IsAnswered() const { return this->Progress == State::Answered; }

  /// Whether it is about what the view shows.
  bool IsCurrent(vtkVolumeBenchMapper* mapper) const;

  /// Why there is no answer; empty when nothing was asked for.
  const std::string& GetNote() const { return this->Note; }

private:
  enum class State
  {
    Idle,    // nothing was asked for
    Waiting, // for a still picture
    Answered,
    Failed
  };

  void Fail(const std::string& reason);
  vtkMTimeType SettingsTime(vtkVolumeBenchMapper* mapper) const;

  std::string Refusal;
  State Progress = State::Idle;
  std::string Note;
  ChangeStamp Stamp = 0;                // of the picture that was asked about
  bool Shown = false;                   // the last frame was that picture
  vtkMTimeType FollowedAt = 0;          // of the newest setting in the last frame
  vtkWeakPointer<vtkRenderer> Renderer; // of the last frame
  vtkWeakPointer<vtkVolume> Volume;
};
}

#endif
