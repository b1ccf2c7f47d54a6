#ifndef VO_COMPAT_IFL_ERROR_H
#define VO_COMPAT_IFL_ERROR_H

#include <ifl/iflTypes.h>

/** What a call answers: iflOKAY, or why it failed. The values but for iflOKAY = 0 are this library's own. */
typedef int iflStatus;
enum { iflOKAY = 0, iflBADPARAM, iflUNSUPPORTED, iflOPENFAILED, iflREADFAILED, iflMALLOCFAILED };

/** Writes the text of a status into buffer, at most length bytes with the closing 0, and returns buffer. For the status
    of this thread's last failure: one line that names the file, what was expected and what was found. */
IFL_API char *iflStatusToString(iflStatus status, char *buffer, int length);

#endif
