/* interface_layout.c - sizes and offsets of the structs of contact_elements.h with 8-byte pointers.
 *
 * The numbers are part of the interface: interface_layout.f90 checks the Fortran module against the same ones.
 */
#include "client_support.h"
#include "interface_parts.h"

#include <stddef.h>
#include <stdio.h>

typedef struct field {
  const char *name;
  size_t found, expected; /* offset [bytes] */
} field;

#define FIELD(type, name, expected) {#type "." #name, offsetof(type, name), expected}

static void layout(const char *what, size_t size, size_t expected, const field *fields, size_t count)
{
  int pass = size == expected;
  for (size_t i = 0; i < count; i++)
    if (fields[i].found != fields[i].expected) {
      printf("     %s at %zu, not %zu\n", fields[i].name, fields[i].found, fields[i].expected);
      pass = 0;
    }
  client_check(pass, client_text(what, (long)size));
}

static void layout_info(void)
{
  static const field fields[] = {
      FIELD(cte_info, struct_size, 0), FIELD(cte_info, dimension, 4), FIELD(cte_info, nodes_minimum, 8),
      FIELD(cte_info, nodes_maximum, 12), FIELD(cte_info, slave_nodes, 16), FIELD(cte_info, master_nodes, 20),
      FIELD(cte_info, unknowns, 24), FIELD(cte_info, parameters, 28), FIELD(cte_info, history, 32),
      FIELD(cte_info, points, 36), FIELD(cte_info, projected, 40), FIELD(cte_info, requests, 44),
      FIELD(cte_info, symmetric, 48), FIELD(cte_info, operations, 52), FIELD(cte_info, workspace, 56),
      FIELD(cte_info, formulation, 64), FIELD(cte_info, name, 72), FIELD(cte_info, documentation, 80)};
  layout("layout of cte_info, bytes:", sizeof(cte_info), 88, fields, sizeof fields / sizeof fields[0]);
}

static void layout_arguments(void)
{
  static const field fields[] = {
      FIELD(cte_arguments, struct_size, 0), FIELD(cte_arguments, request, 4), FIELD(cte_arguments, nnode, 8),
      FIELD(cte_arguments, parameter_count, 12), FIELD(cte_arguments, x, 16), FIELD(cte_arguments, u, 24),
      FIELD(cte_arguments, parameters, 32), FIELD(cte_arguments, history_accepted, 40),
      FIELD(cte_arguments, history_trial, 48), FIELD(cte_arguments, f, 56), FIELD(cte_arguments, k, 64),
      FIELD(cte_arguments, output, 72), FIELD(cte_arguments, energy, 80), FIELD(cte_arguments, f_scale, 88),
      FIELD(cte_arguments, k_scale, 96), FIELD(cte_arguments, k_row_stride, 104),
      FIELD(cte_arguments, k_col_stride, 112), FIELD(cte_arguments, unknown_map, 120),
      FIELD(cte_arguments, x_node_stride, 128), FIELD(cte_arguments, u_node_stride, 136),
      FIELD(cte_arguments, slave_row, 144), FIELD(cte_arguments, workspace, 152),
      FIELD(cte_arguments, workspace_size, 160), FIELD(cte_arguments, nslave, 168),
      FIELD(cte_arguments, padding, 172), FIELD(cte_arguments, u_old, 176), FIELD(cte_arguments, v, 184),
      FIELD(cte_arguments, dt, 192), FIELD(cte_arguments, dt_ratio, 200), FIELD(cte_arguments, status, 208),
      FIELD(cte_arguments, closed_points, 212), FIELD(cte_arguments, error_argument, 216),
      FIELD(cte_arguments, error_index, 220)};
  layout("layout of cte_arguments, bytes:", sizeof(cte_arguments), 224, fields, sizeof fields / sizeof fields[0]);
}

static void layout_batch(void)
{
  static const field fields[] = {
      FIELD(cte_batch, struct_size, 0), FIELD(cte_batch, request, 4), FIELD(cte_batch, parameter_count, 8),
      FIELD(cte_batch, nslave, 12), FIELD(cte_batch, x, 16), FIELD(cte_batch, u, 24),
      FIELD(cte_batch, parameters, 32), FIELD(cte_batch, history_accepted, 40),
      FIELD(cte_batch, history_trial, 48), FIELD(cte_batch, status, 56), FIELD(cte_batch, code, 64),
      FIELD(cte_batch, connectivity, 72), FIELD(cte_batch, global_nodes, 80), FIELD(cte_batch, global_f, 88),
      FIELD(cte_batch, csr_values, 96), FIELD(cte_batch, csr_map, 104), FIELD(cte_batch, f, 112),
      FIELD(cte_batch, k, 120), FIELD(cte_batch, output, 128), FIELD(cte_batch, energy, 136),
      FIELD(cte_batch, f_scale, 144), FIELD(cte_batch, k_scale, 152), FIELD(cte_batch, x_element_stride, 160),
      FIELD(cte_batch, x_node_stride, 168), FIELD(cte_batch, x_component_stride, 176),
      FIELD(cte_batch, u_element_stride, 184), FIELD(cte_batch, u_node_stride, 192),
      FIELD(cte_batch, u_component_stride, 200), FIELD(cte_batch, parameter_element_stride, 208),
      FIELD(cte_batch, f_element_stride, 216), FIELD(cte_batch, k_element_stride, 224),
      FIELD(cte_batch, slave_row, 232), FIELD(cte_batch, workspace, 240), FIELD(cte_batch, workspace_size, 248),
      FIELD(cte_batch, failed, 256), FIELD(cte_batch, error_argument, 264), FIELD(cte_batch, error_index, 268)};
  layout("layout of cte_batch, bytes:", sizeof(cte_batch), 272, fields, sizeof fields / sizeof fields[0]);
}

static void layout_projection(void)
{
  static const field fields[] = {
      FIELD(cte_projection, zeta, 0), FIELD(cte_projection, distance, 16), FIELD(cte_projection, definiteness, 24),
      FIELD(cte_projection, verdict, 32), FIELD(cte_projection, feature, 36), FIELD(cte_projection, boxes, 40),
      FIELD(cte_projection, steps, 44)};
  layout("layout of cte_projection, bytes:", sizeof(cte_projection), 48, fields, sizeof fields / sizeof fields[0]);
}

static void layout_patch(void)
{
  static const field fields[] = {
      FIELD(cte_patch, struct_size, 0), FIELD(cte_patch, slave_points, 4), FIELD(cte_patch, master_nodes, 8),
      FIELD(cte_patch, facets, 12), FIELD(cte_patch, facet, 16), FIELD(cte_patch, connectivity, 24),
      FIELD(cte_patch, edge, 32), FIELD(cte_patch, vertex, 40), FIELD(cte_patch, reach, 48)};
  layout("layout of cte_patch, bytes:", sizeof(cte_patch), 56, fields, sizeof fields / sizeof fields[0]);
}

static void layout_api_table(void)
{
  static const field fields[] = {
      FIELD(cte_api_table, struct_size, 0), FIELD(cte_api_table, version, 4),
      FIELD(cte_api_table, element_count, 8), FIELD(cte_api_table, element_get, 16),
      FIELD(cte_api_table, element_find, 24), FIELD(cte_api_table, element_info, 32),
      FIELD(cte_api_table, element_unknown, 40), FIELD(cte_api_table, element_parameter, 48),
      FIELD(cte_api_table, element_check_parameters, 56), FIELD(cte_api_table, element_history_init, 64),
      FIELD(cte_api_table, element_evaluate, 72), FIELD(cte_api_table, element_batch_workspace, 80),
      FIELD(cte_api_table, element_evaluate_batch, 88), FIELD(cte_api_table, csr_map, 96),
      FIELD(cte_api_table, code_message, 104), FIELD(cte_api_table, status_message, 112),
      FIELD(cte_api_table, argument_name, 120), FIELD(cte_api_table, element_message, 128),
      FIELD(cte_api_table, history_transfer, 136), FIELD(cte_api_table, history_augment, 144),
      FIELD(cte_api_table, element_project, 152), FIELD(cte_api_table, patch_info, 160),
      FIELD(cte_api_table, patch_evaluate, 168), FIELD(cte_api_table, element_evaluate_batch_threads, 176),
      FIELD(cte_api_table, csr_blocks, 184)};
  layout("layout of cte_api_table, bytes:", sizeof(cte_api_table), 192, fields, sizeof fields / sizeof fields[0]);
}

void interface_layout(void)
{
  layout_info();
  layout_arguments();
  layout_batch();
  layout_projection();
  layout_patch();
  layout_api_table();
}
