/* SPDX-License-Identifier: MIT
 * contactlaws for C, and for every language that calls C.
 *
 * The normal points from body 1 to body 2, v and w are velocities and spins, forces act on body 2. SI units.
 * A law never changes after it is made: threads may share it. Each contact keeps contactlaws_state_size() doubles of its own.
 * A function that can fail says so by its result, NULL or 1; contactlaws_error() then has the reason.
 */
#ifndef CONTACTLAWS_H
#define CONTACTLAWS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct contactlaws_law contactlaws_law;

/* A sphere; eleven doubles in a row. Body 1 may be a wall: radius 0, and x its point that is nearest to body 2. */
typedef struct contactlaws_body {
  double x[3];   /* of the centre [m] */
  double v[3];   /* of the centre [m/s] */
  double w[3];   /* [rad/s] */
  double radius; /* [m] */
  double mass;   /* [kg]; 0: held in space */
} contactlaws_body;

/* A law by name, with `count` parameters by name. Those left out are 0, stiffness_ratio is 1, body 2 is of body 1's material.
 *
 *   smooth_hertz             young [Pa], poisson, young2, poisson2
 *   dry_hill                 as smooth_hertz; friction, and damping_constant or restitution; other shear histories:
 *                            dry_hill/rescaled, dry_hill/displacement, dry_hill/displacement_rescaled, dry_hill/partial_slip
 *   hill                     as dry_hill; suction [Pa], decay_length, rupture_gap
 *   wet_grains               as dry_hill; surface_tension [N/m], contact_angle [rad], bridge_volume [m^3], of a new bridge: it
 *                            forms at touch. Add the state value returned_volume to your own sum, and set it to 0
 *   cohesive_powder          as dry_hill; work_of_adhesion [J/m^2], rolling_friction
 *   plastic_grains           as smooth_hertz; yield_pressure [Pa], friction
 *   rough_ballast            as smooth_hertz; fractal_dimension, roughness [m], friction, stiffness_ratio
 *   linear_friction          modulus [Pa], friction, stiffness_ratio
 *   linear_spring_dashpot    normal_stiffness [N/m], friction, stiffness_ratio, damping_constant or restitution
 *
 * NULL if there is no such law or parameter, or a value is out of its range. */
contactlaws_law* contactlaws_make(const char* law, size_t count, const char* const* names, const double* values);

/* A law from a file as examples/contact_path reads it (contactlaws_toml.cpp). The moduli come from its [pair], radii and masses
 * from the bodies of each contact. NULL with file, line and column of a fault. */
contactlaws_law* contactlaws_read(const char* file);

/* NULL is allowed. */
void contactlaws_free(contactlaws_law* law);

/* Why the last call that failed in this thread did; valid until the next one fails. */
const char* contactlaws_error(void);

/* The history of one contact: how many doubles; name, SI unit, and factor (1 or -1) of each when bodies 1 and 2 are swapped.
 * `i` must be below the size. */
size_t contactlaws_state_size(const contactlaws_law* law);
const char* contactlaws_state_name(const contactlaws_law* law, size_t i);
const char* contactlaws_state_unit(const contactlaws_law* law, size_t i);
int contactlaws_exchange_sign(const contactlaws_law* law, size_t i);

/* The history of a new contact: zeros, but for a law from a file that starts wet. */
void contactlaws_new_state(const contactlaws_law* law, double* state);

/* Wets one contact where its gap (-overlap) is at most `moisture_gap` [m]; its next step has the bridge.
 * 1 if the law has none. */
int contactlaws_make_wet(const contactlaws_law* law, double overlap, double moisture_gap, double* state);

/* Largest gap across which the law acts [m]: a neighbour list must reach this far beyond touch. */
double contactlaws_range(const contactlaws_law* law, double radius1, double radius2);

/* One step of `count` contacts, each with a row in every array: force on body 2 [N] (body 1 gets the opposite), torques about
 * both centres [N m], history updated. dt = 0 [s], for set-up and queries: the force of the last step; the history stays.
 * 1 if a radius or mass is out of range: nothing has changed then. A NaN elsewhere gives a NaN force. */
int contactlaws_step(const contactlaws_law* law, double dt, size_t count, const contactlaws_body* body1,
                     const contactlaws_body* body2, double* state, double (*force)[3], double (*torque1)[3],
                     double (*torque2)[3]);

#ifdef __cplusplus
}
#endif
#endif
