#ifndef VO_ERROR_H
#define VO_ERROR_H

#include <vo/Enums.h>

/** The last error (guide, pages 63-64). One number and one text per thread; the handler, the debug level and the
    debug stream are shared by all threads. Every action that fails sets both, calls the handler, and does nothing
    else. */
class VO_API voError : public voErrorTypeScope
{
public:
    /** The last code; resets it (alone) to NO_ERROR. */
    static voErrorType getErrorNumber();
    /** The last text, or NULL; resets it (alone). Valid until the next error of this thread. */
    static const char *getErrorString();

    /** Set the code or the text; they do not call the handler. The text is copied. */
    static void setErrorNumber(voErrorType number);
    static void setErrorNumber(int number);
    static void setErrorString(const char *text);

    /** Installs a function that is called at every error, the ones raised inside the library included; NULL
        removes it. Returns the handler before, or NULL. */
    static void (*setErrorHandler(void (*handler)(void)))(void);
    /** Calls the installed handler, if any. */
    static void callErrorHandler();

    /** All at once, for extensions: sets the code and the text "action: text", prints it at debug level 1, and calls the
        handler. */
    static void report(const char *action, voErrorType number, const char *text);

    /** Messages of a level up to this one are printed; 0, the initial value, prints none. The environment variable
        VO_DEBUG sets the initial value. */
    static void setDebugLevel(int level);
    /** Where messages go: stderr unless set. The stream stays the caller's. */
    static void setDebugStream(FILE *stream);
    static void setDebugStream(std::ostream &stream);
};

#endif
