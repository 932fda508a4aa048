/* SPDX-License-Identifier: MIT */
#include "contact/contact_host.h"
#include "support/console.h"
void contact_host_list(FILE *file)
{
    (void)file;
}
int contact_host_check(const char *host)
{
    (void)host;
    return STATUS_OK;
}
char *contact_host_text(const char *host, const struct contact_request *request, const struct contact_models *models,
                        const double *speed_m_s, size_t speeds)
{
    (void)host;
    (void)request;
    (void)models;
    (void)speed_m_s;
    (void)speeds;
    usage_error("x");
    return NULL;
}
