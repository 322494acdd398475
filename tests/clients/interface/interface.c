/* interface.c - the whole interface, used as documented; floating-point traps on.
 *
 * Bit-for-bit where contact_elements.h says so (same input, same bits), else to the tolerance stated at the
 * check. interface.f90 is the twin: both print the same lines.
 */
#define _GNU_SOURCE /* feenableexcept */
#include "client_support.h"
#include "interface_parts.h"

#include <fenv.h>
#include <stdio.h>

int main(void)
{
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  setvbuf(stdout, NULL, _IOLBF, 0); /* a trap must not swallow what came before */
  interface_layout();
  interface_constants();
  interface_walk();
  interface_evaluate();
  interface_entries();
  interface_batch();
  interface_friction();
  interface_transfer();
  interface_multipliers();
  interface_multiplier_batch();
  interface_augmented();
  interface_project();
  interface_patch();
  interface_edges();
  printf("%s interface, %d failures\n", client_failures ? "FAIL" : "PASS", client_failures);
  return client_failures ? 1 : 0;
}
