/* SPDX-License-Identifier: MIT */
/* The request that the browser's module stores. Every export reads or writes it, so that JavaScript passes text and
 * arrays of doubles. */
#ifndef COR_WEB_WEB_H
#define COR_WEB_WEB_H

#include "cor/scene.h"

#if defined(__wasm__)
#define WEB_EXPORT(name) __attribute__((export_name(#name)))
#else
#define WEB_EXPORT(name)
#endif

enum { WEB_SPEEDS = 64, WEB_VALUE = 24 * WEB_SPEEDS, WEB_NAME = 32 };

/* A request: the options of corgen contact, and speed-min, speed-max, tolerance of corgen embed */
struct web_request {
    struct cor_scene scene;
    enum cor_law law;
    struct cor_scene_contact contact[COR_SCENE_ENDS];
    int count;
    double speed_m_s[WEB_SPEEDS];
    size_t speeds;
    int steps_given, at_surface;                    /* at_surface: the given end is "surface" */
    double steps;                                   /* number of time steps in the shortest contact */
    double speed_min_m_s, speed_max_m_s, tolerance; /* of corgen embed */
    const struct cor_simulator *simulator;          /* NULL: none is chosen */
    char version[WEB_VALUE];                        /* version of the simulator */
};

/* web_now: the last correct request. web_wrong: the option that made a later request wrong, and a sentence */
extern struct web_request web_now;
extern struct web_wrong {
    char option[WEB_NAME], text[WEB_VALUE + COR_SIMULATOR_REASON];
} web_wrong;

#endif
