/* core/sundials.c - see core/sundials.h.
 *
 * SUNDIALS 7 moved error handlers from the integrator to its context. All handlers of a stack are
 * called, and the first one prints, so the stack is cleared. Warnings go to a logger, which prints
 * them to standard output. The library prints nothing, so the logger is removed. A debug build of
 * SUNDIALS uses the logger without checking that there is one, and keeps it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include <cvode/cvode.h>

#include "core/sundials.h"

#if HAVE_DECL_SUNCONTEXT_PUSHERRHANDLER
static void keep_message(int line, const char *function, const char *file, const char *message,
                         SUNErrCode code, void *user, SUNContext context)
{
	struct hawser__sundials *sundials = user;

	(void)line, (void)file, (void)context;
	snprintf(sundials->message, sizeof sundials->message, "%s: %s", function,
	         message ? message : SUNGetErrMsg(code));
}

int hawser__sundials_open(struct hawser__sundials *sundials)
{
	return !SUNContext_Create(SUN_COMM_NULL, &sundials->context) &&
#if SUNDIALS_LOGGING_LEVEL < 4
	       !SUNContext_SetLogger(sundials->context, NULL) &&
#endif
	       !SUNContext_ClearErrHandlers(sundials->context) &&
	       !SUNContext_PushErrHandler(sundials->context, keep_message, sundials);
}

int hawser__sundials_listen(struct hawser__sundials *sundials, void *cvode)
{
	(void)sundials, (void)cvode;
	return 1;
}
#else
static void keep_message(int code, const char *module, const char *function, char *message,
                         void *user)
{
	struct hawser__sundials *sundials = user;

	(void)module;
	if (code < 0)
		snprintf(sundials->message, sizeof sundials->message, "%s: %s", function, message);
}

int hawser__sundials_open(struct hawser__sundials *sundials)
{
	return !SUNContext_Create(NULL, &sundials->context);
}

int hawser__sundials_listen(struct hawser__sundials *sundials, void *cvode)
{
	return !CVodeSetErrHandlerFn(cvode, keep_message, sundials);
}
#endif

void hawser__sundials_clear(struct hawser__sundials *sundials)
{
	if (sundials->context)
		SUNContext_Free(&sundials->context);
	sundials->context = NULL;
}
