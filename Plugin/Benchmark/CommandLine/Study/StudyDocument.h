// A study as JSON: its defaults, and what --quick makes of it. The rules are those of
// Python/volumebench/study.py and study_file.py.
#ifndef volumebench_StudyDocument_h
#define volumebench_StudyDocument_h

#include "JsonFile.h"

#include <string>

namespace volumebench
{
/// The study with a value for every key that it leaves out, and its transfer functions as an object
/// from dataset to list. `document` has passed its schema; errors name `name`.
Json WithDefaults(const Json& document, const std::string& name);

/// What the study itself calls quick, or else its extremes with short timing.
Json QuickDocument(const Json& document, const std::string& name);

/// The keys of a study that this program heeds or knows to have no meaning here.
bool IsStudyKey(const std::string& key);
}

#endif
