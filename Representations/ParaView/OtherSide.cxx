#include "OtherSide.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPVPluginsInformation.h"
#include "vtkProcessModule.h"
#include "vtkSMPluginManager.h"
#include "vtkSMProxy.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkSMSessionClient.h"
#include "vtkWeakPointer.h"

#include <cstring>
#include <string>

namespace
{
constexpr const char* PluginName = "VolumeBench";

// What a server complains of whose client cannot make our part of a representation.
constexpr const char* MissingInClient =
  "Missing data representation subproxy 'VolumeBenchRepresentation'";

// Returns the number of our plugin among those that are loaded, or -1.
int NumberOfPlugin(vtkPVPluginsInformation* plugins)
{
  const unsigned int count = plugins ? plugins->GetNumberOfPlugins() : 0;
  for (unsigned int number = 0; number < count; ++number)
  {
    const char* name = plugins->GetPluginName(number);
    if (name && std::strcmp(name, PluginName) == 0 && plugins->GetPluginLoaded(number))
    {
      return static_cast<int>(number);
    }
  }
  return -1;
}

std::string VersionOf(vtkPVPluginsInformation* plugins, int number)
{
  const char* version = plugins->GetPluginVersion(number);
  return version ? version : "of no version";
}

// With an object, as ParaView's window shows nothing of generic warnings but the place in the
// source.
void WarnOfMissing(vtkObject* plugins, const char* file)
{
  vtkWarningWithObjectMacro(plugins,
    "The server has no plugin "
      << PluginName << ", so its representations, readers and benchmark are missing. Load it there "
      << "too, with Tools > Manage Plugins > Remote Plugins > Load New, or in Python with "
      << "LoadPlugin(\"" << (file ? file : PluginName) << "\", remote=True), where the path is the "
      << "server's. Load it before image data are shown.");
}

void WarnOfVersions(vtkObject* plugins, const std::string& here, const std::string& there)
{
  vtkWarningWithObjectMacro(plugins,
    "The client has "
      << PluginName << " " << here << ", the server " << there
      << ". What one of them has not fails or has no effect: use the same version on "
         "both sides.");
}

// Looks at the server when something is made there that might be shown or measured: a script has
// loaded its plugins by then.
class ServerCheck : public vtkCommand
{
public:
  static ServerCheck* New() { return new ServerCheck; }
  vtkTypeMacro(ServerCheck, vtkCommand);

  void Execute(vtkObject*, unsigned long, void* data) override
  {
    const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(data);
    const bool isProxy = registered && registered->Proxy &&
      registered->Type == vtkSMProxyManager::RegisteredProxyInformation::PROXY;
    const std::string group = isProxy && registered->GroupName ? registered->GroupName : "";
    if (group != "sources" && group != "representations")
    {
      return;
    }
    auto* session = vtkSMSessionClient::SafeDownCast(registered->Proxy->GetSession());
    if (session && session != this->Told)
    {
      this->Check(session);
    }
  }

private:
  void Check(vtkSMSession* session)
  {
    vtkSMPluginManager* plugins = vtkSMProxyManager::GetProxyManager()->GetPluginManager();
    vtkPVPluginsInformation* ours = plugins->GetLocalInformation();
    vtkPVPluginsInformation* theirs = plugins->GetRemoteInformation(session);
    const int here = NumberOfPlugin(ours);
    const int there = NumberOfPlugin(theirs);
    if (here < 0)
    {
      return;
    }
    if (there < 0)
    {
      this->Told = session;
      WarnOfMissing(plugins, ours->GetPluginFileName(here));
    }
    else if (const std::string version = VersionOf(ours, here); version != VersionOf(theirs, there))
    {
      this->Told = session;
      WarnOfVersions(plugins, version, VersionOf(theirs, there));
    }
  }

  vtkWeakPointer<vtkSMSession> Told;
};

// ParaView sends what a server says to the client, which has nothing of ours to say it.
void CheckClient(vtkObject* window, unsigned long, void*, void* text)
{
  const auto* message = static_cast<const char*>(text);
  if (message && std::strstr(message, MissingInClient))
  {
    vtkWarningWithObjectMacro(window,
      "The server has the plugin "
        << PluginName
        << ", the client has not, so no image data can be shown. Load it in the client "
        << "too, with Tools > Manage Plugins > Local Plugins > Load New, or in Python with "
        << "LoadPlugin(\"/path/" << PluginName << ".so\", remote=False), and show the data anew.");
  }
}
}

void volumebench::WatchOtherSide()
{
  switch (vtkProcessModule::GetProcessType())
  {
    case vtkProcessModule::PROCESS_CLIENT:
    {
      vtkNew<ServerCheck> check;
      vtkSMProxyManager::GetProxyManager()->AddObserver(vtkCommand::RegisterEvent, check);
      break;
    }
    case vtkProcessModule::PROCESS_SERVER:
    case vtkProcessModule::PROCESS_DATA_SERVER:
    case vtkProcessModule::PROCESS_RENDER_SERVER:
    {
      vtkNew<vtkCallbackCommand> check;
      check->SetCallback(CheckClient);
      vtkOutputWindow::GetInstance()->AddObserver(vtkCommand::ErrorEvent, check);
      break;
    }
    default: // batch: one process is both
      break;
  }
}
