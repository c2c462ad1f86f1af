#include "ServerConnection.h"

#include "vtkClientSocket.h"
#include "vtkMultiProcessController.h"
#include "vtkPVRenderView.h"
#include "vtkPVSession.h"
#include "vtkPVSynchronizedRenderer.h"
#include "vtkSocketCommunicator.h"
#include "vtkSynchronizedRenderers.h"

#include <cerrno>
#include <poll.h>
#include <sys/socket.h>

namespace
{
constexpr int NoSocket = -1;

// Returns the socket to a server: NoSocket where it has been closed, or where there is no server.
int SocketTo(vtkPVSession* session, vtkPVSession::ServerFlags server, bool& hasServer)
{
  vtkMultiProcessController* controller = session ? session->GetController(server) : nullptr;
  auto* communicator =
    controller ? vtkSocketCommunicator::SafeDownCast(controller->GetCommunicator()) : nullptr;
  hasServer = communicator != nullptr;
  vtkClientSocket* socket = communicator ? communicator->GetSocket() : nullptr;
  return socket ? socket->GetSocketDescriptor() : NoSocket;
}

// A connection that was closed has an end to be read, one that idles has nothing, and one that
// speaks has a byte.
bool IsOpen(int socket)
{
  char byte = 0;
  const ssize_t count = recv(socket, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR));
}

void WaitForWord(int socket)
{
  pollfd waiting = { socket, POLLIN, 0 };
  while (poll(&waiting, 1, -1) < 0 && errno == EINTR)
  {
  }
}

// Reaches what ParaView keeps to the view and its subclasses.
class ViewParts : public vtkPVRenderView
{
public:
  static vtkSynchronizedRenderers* PictureReceiver(vtkPVRenderView* view)
  {
    vtkPVSynchronizedRenderer* parts = view->*&ViewParts::SynchronizedRenderers;
    return parts ? parts->GetCSSynchronizer() : nullptr;
  }
};
}

bool volumebench::IsConnected(vtkPVSession* session)
{
  for (const auto server : { vtkPVSession::DATA_SERVER_ROOT, vtkPVSession::RENDER_SERVER_ROOT })
  {
    bool hasServer = false;
    const int socket = SocketTo(session, server, hasServer);
    if (hasServer && !IsOpen(socket))
    {
      return false;
    }
  }
  return true;
}

// ParaView takes what is in memory for the size of a picture that could not be received.
void volumebench::ExpectPicture(vtkPVSession* session, vtkPVRenderView* view)
{
  vtkSynchronizedRenderers* receiver = ViewParts::PictureReceiver(view);
  bool hasServer = false;
  const int socket = SocketTo(session, vtkPVSession::RENDER_SERVER_ROOT, hasServer);
  if (!hasServer || !receiver || !receiver->GetParallelRendering())
  {
    return;
  }
  WaitForWord(socket);
  if (!IsConnected(session))
  {
    receiver->ParallelRenderingOff();
  }
}
