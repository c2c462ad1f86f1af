// Whether the server of a session still answers: ParaView does not notice when it dies, and the
// next question to it ends the client, as does a picture that never comes.
#ifndef volumebench_ServerConnection_h
#define volumebench_ServerConnection_h

class vtkPVRenderView;
class vtkPVSession;

namespace volumebench
{
/// Whether the other ends of the session's connections have neither closed them nor died; true of a
/// session that has no server.
bool IsConnected(vtkPVSession* session);

/// To be called when the client has drawn its share of a picture: waits for the server's, as
/// ParaView does next, and spares ParaView that when the server is gone.
void ExpectPicture(vtkPVSession* session, vtkPVRenderView* view);
}

#endif
