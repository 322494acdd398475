/* describe.c - prints the interface as tests/abi/baseline.txt has it; the test fills in the fields. */
#include "contact_elements.h"

#include <stddef.h>
#include <stdio.h>

static int element(int32_t index)
{
  const cte_element *e = cte_element_get(index);
  const char *name = NULL;
  cte_info info = CTE_INFO_INIT;
  if (cte_element_info(e, 0, &info) != CTE_SUCCESS)
    return 1;
  printf("element %d %s:", (int)index, info.name);
  for (int32_t i = 0; i < info.parameters; i++) {
    if (cte_element_parameter(e, i, &name, NULL, NULL, NULL, NULL) != CTE_SUCCESS)
      return 1;
    printf(" %s", name);
  }
  printf("\n");
  return 0;
}

int main(void)
{
  int failures = 0;
  /* fields */
  for (int32_t i = 0; i < cte_element_count(); i++)
    failures += element(i);
  return failures != 0;
}
