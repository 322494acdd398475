! interface_layout.f90 - sizes and offsets of the types of the module contact_elements with 8-byte addresses.
!
! The numbers are part of the interface: interface_layout.c checks the C header against the same ones.
module interface_layout
  use, intrinsic :: iso_c_binding, only: c_intptr_t, c_loc, c_ptr, c_sizeof
  use contact_elements
  use client_support
  implicit none
  private
  public :: interface_layout_run

  integer(c_intptr_t) :: start     ! address of the variable looked at
  integer :: mismatches

contains

  ! The component at `address` should stand `expected` bytes from the start.
  subroutine field(name, address, expected)
    character(len=*), intent(in) :: name
    type(c_ptr), intent(in) :: address
    integer, intent(in) :: expected
    integer(c_intptr_t) :: offset
    offset = transfer(address, offset) - start
    if (offset == expected) return
    print '(3a,i0,a,i0)', '     ', name, ' at ', offset, ', not ', expected
    mismatches = mismatches + 1
  end subroutine field

  subroutine begin(address)
    type(c_ptr), intent(in) :: address
    start = transfer(address, start)
    mismatches = 0
  end subroutine begin

  subroutine finish(what, bytes, expected)
    character(len=*), intent(in) :: what
    integer(i8), intent(in) :: bytes
    integer, intent(in) :: expected
    call client_check(bytes == expected .and. mismatches == 0, client_text('layout of '//what//', bytes:', bytes))
  end subroutine finish

  subroutine layout_info()
    type(cte_info), target :: v
    call begin(c_loc(v))
    call field('struct_size', c_loc(v%struct_size), 0)
    call field('dimension', c_loc(v%dimension), 4)
    call field('nodes_minimum', c_loc(v%nodes_minimum), 8)
    call field('nodes_maximum', c_loc(v%nodes_maximum), 12)
    call field('slave_nodes', c_loc(v%slave_nodes), 16)
    call field('master_nodes', c_loc(v%master_nodes), 20)
    call field('unknowns', c_loc(v%unknowns), 24)
    call field('parameters', c_loc(v%parameters), 28)
    call field('history', c_loc(v%history), 32)
    call field('points', c_loc(v%points), 36)
    call field('projected', c_loc(v%projected), 40)
    call field('requests', c_loc(v%requests), 44)
    call field('symmetric', c_loc(v%symmetric), 48)
    call field('operations', c_loc(v%operations), 52)
    call field('workspace', c_loc(v%workspace), 56)
    call field('formulation', c_loc(v%formulation), 64)
    call field('name', c_loc(v%name), 72)
    call field('documentation', c_loc(v%documentation), 80)
    call finish('cte_info', int(c_sizeof(v), i8), 88)
  end subroutine layout_info

  subroutine layout_arguments()
    type(cte_arguments), target :: v
    call begin(c_loc(v))
    call field('struct_size', c_loc(v%struct_size), 0)
    call field('request', c_loc(v%request), 4)
    call field('nnode', c_loc(v%nnode), 8)
    call field('parameter_count', c_loc(v%parameter_count), 12)
    call field('x', c_loc(v%x), 16)
    call field('u', c_loc(v%u), 24)
    call field('parameters', c_loc(v%parameters), 32)
    call field('history_accepted', c_loc(v%history_accepted), 40)
    call field('history_trial', c_loc(v%history_trial), 48)
    call field('f', c_loc(v%f), 56)
    call field('k', c_loc(v%k), 64)
    call field('output', c_loc(v%output), 72)
    call field('energy', c_loc(v%energy), 80)
    call field('f_scale', c_loc(v%f_scale), 88)
    call field('k_scale', c_loc(v%k_scale), 96)
    call field('k_row_stride', c_loc(v%k_row_stride), 104)
    call field('k_col_stride', c_loc(v%k_col_stride), 112)
    call field('unknown_map', c_loc(v%unknown_map), 120)
    call field('x_node_stride', c_loc(v%x_node_stride), 128)
    call field('u_node_stride', c_loc(v%u_node_stride), 136)
    call field('slave_row', c_loc(v%slave_row), 144)
    call field('workspace', c_loc(v%workspace), 152)
    call field('workspace_size', c_loc(v%workspace_size), 160)
    call field('nslave', c_loc(v%nslave), 168)
    call field('padding', c_loc(v%padding), 172)
    call field('u_old', c_loc(v%u_old), 176)
    call field('v', c_loc(v%v), 184)
    call field('dt', c_loc(v%dt), 192)
    call field('dt_ratio', c_loc(v%dt_ratio), 200)
    call field('status', c_loc(v%status), 208)
    call field('closed_points', c_loc(v%closed_points), 212)
    call field('error_argument', c_loc(v%error_argument), 216)
    call field('error_index', c_loc(v%error_index), 220)
    call finish('cte_arguments', int(c_sizeof(v), i8), 224)
  end subroutine layout_arguments

  subroutine layout_batch()
    type(cte_batch), target :: v
    call begin(c_loc(v))
    call field('struct_size', c_loc(v%struct_size), 0)
    call field('request', c_loc(v%request), 4)
    call field('parameter_count', c_loc(v%parameter_count), 8)
    call field('nslave', c_loc(v%nslave), 12)
    call field('x', c_loc(v%x), 16)
    call field('u', c_loc(v%u), 24)
    call field('parameters', c_loc(v%parameters), 32)
    call field('history_accepted', c_loc(v%history_accepted), 40)
    call field('history_trial', c_loc(v%history_trial), 48)
    call field('status', c_loc(v%status), 56)
    call field('code', c_loc(v%code), 64)
    call field('connectivity', c_loc(v%connectivity), 72)
    call field('global_nodes', c_loc(v%global_nodes), 80)
    call field('global_f', c_loc(v%global_f), 88)
    call field('csr_values', c_loc(v%csr_values), 96)
    call field('csr_map', c_loc(v%csr_map), 104)
    call field('f', c_loc(v%f), 112)
    call field('k', c_loc(v%k), 120)
    call field('output', c_loc(v%output), 128)
    call field('energy', c_loc(v%energy), 136)
    call field('f_scale', c_loc(v%f_scale), 144)
    call field('k_scale', c_loc(v%k_scale), 152)
    call field('x_element_stride', c_loc(v%x_element_stride), 160)
    call field('x_node_stride', c_loc(v%x_node_stride), 168)
    call field('x_component_stride', c_loc(v%x_component_stride), 176)
    call field('u_element_stride', c_loc(v%u_element_stride), 184)
    call field('u_node_stride', c_loc(v%u_node_stride), 192)
    call field('u_component_stride', c_loc(v%u_component_stride), 200)
    call field('parameter_element_stride', c_loc(v%parameter_element_stride), 208)
    call field('f_element_stride', c_loc(v%f_element_stride), 216)
    call field('k_element_stride', c_loc(v%k_element_stride), 224)
    call field('slave_row', c_loc(v%slave_row), 232)
    call field('workspace', c_loc(v%workspace), 240)
    call field('workspace_size', c_loc(v%workspace_size), 248)
    call field('failed', c_loc(v%failed), 256)
    call field('error_argument', c_loc(v%error_argument), 264)
    call field('error_index', c_loc(v%error_index), 268)
    call finish('cte_batch', int(c_sizeof(v), i8), 272)
  end subroutine layout_batch

  subroutine layout_projection()
    type(cte_projection), target :: v
    call begin(c_loc(v))
    call field('zeta', c_loc(v%zeta), 0)
    call field('distance', c_loc(v%distance), 16)
    call field('definiteness', c_loc(v%definiteness), 24)
    call field('verdict', c_loc(v%verdict), 32)
    call field('feature', c_loc(v%feature), 36)
    call field('boxes', c_loc(v%boxes), 40)
    call field('steps', c_loc(v%steps), 44)
    call finish('cte_projection', int(c_sizeof(v), i8), 48)
  end subroutine layout_projection

  subroutine layout_patch()
    type(cte_patch), target :: v
    call begin(c_loc(v))
    call field('struct_size', c_loc(v%struct_size), 0)
    call field('slave_points', c_loc(v%slave_points), 4)
    call field('master_nodes', c_loc(v%master_nodes), 8)
    call field('facets', c_loc(v%facets), 12)
    call field('facet', c_loc(v%facet), 16)
    call field('connectivity', c_loc(v%connectivity), 24)
    call field('edge', c_loc(v%edge), 32)
    call field('vertex', c_loc(v%vertex), 40)
    call field('reach', c_loc(v%reach), 48)
    call finish('cte_patch', int(c_sizeof(v), i8), 56)
  end subroutine layout_patch

  subroutine layout_api_table()
    type(cte_api_table), target :: v
    call begin(c_loc(v))
    call field('struct_size', c_loc(v%struct_size), 0)
    call field('version', c_loc(v%version), 4)
    call field('element_count', c_loc(v%element_count), 8)
    call field('element_get', c_loc(v%element_get), 16)
    call field('element_find', c_loc(v%element_find), 24)
    call field('element_info', c_loc(v%element_info), 32)
    call field('element_unknown', c_loc(v%element_unknown), 40)
    call field('element_parameter', c_loc(v%element_parameter), 48)
    call field('element_check_parameters', c_loc(v%element_check_parameters), 56)
    call field('element_history_init', c_loc(v%element_history_init), 64)
    call field('element_evaluate', c_loc(v%element_evaluate), 72)
    call field('element_batch_workspace', c_loc(v%element_batch_workspace), 80)
    call field('element_evaluate_batch', c_loc(v%element_evaluate_batch), 88)
    call field('csr_map', c_loc(v%csr_map), 96)
    call field('code_message', c_loc(v%code_message), 104)
    call field('status_message', c_loc(v%status_message), 112)
    call field('argument_name', c_loc(v%argument_name), 120)
    call field('element_message', c_loc(v%element_message), 128)
    call field('history_transfer', c_loc(v%history_transfer), 136)
    call field('history_augment', c_loc(v%history_augment), 144)
    call field('element_project', c_loc(v%element_project), 152)
    call field('patch_info', c_loc(v%patch_info), 160)
    call field('patch_evaluate', c_loc(v%patch_evaluate), 168)
    call field('element_evaluate_batch_threads', c_loc(v%element_evaluate_batch_threads), 176)
    call field('csr_blocks', c_loc(v%csr_blocks), 184)
    call finish('cte_api_table', int(c_sizeof(v), i8), 192)
  end subroutine layout_api_table

  subroutine interface_layout_run()
    call layout_info()
    call layout_arguments()
    call layout_batch()
    call layout_projection()
    call layout_patch()
    call layout_api_table()
  end subroutine interface_layout_run

end module interface_layout
