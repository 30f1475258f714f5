/* core/sundials.h - a context of SUNDIALS that prints nothing; its last message is kept.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef HAWSER_CORE_SUNDIALS_H
#define HAWSER_CORE_SUNDIALS_H

#include <sundials/sundials_context.h>

struct hawser__sundials {
	SUNContext context;
	char message[256]; /* of CVODE's last failure */
};

/* Both return 1, or 0 if memory is short. The structure must stay where it is. */
int hawser__sundials_open(struct hawser__sundials *sundials);
/* To be called once the integrator is made by CVodeCreate. */
int hawser__sundials_listen(struct hawser__sundials *sundials, void *cvode);
void hawser__sundials_clear(struct hawser__sundials *sundials);

#endif
