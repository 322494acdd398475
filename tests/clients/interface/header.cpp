/* header.cpp - contact_elements.h is a C++ header too: compiled and used a little. */
#include "contact_elements.h"

#include <cstdio>

int main()
{
  cte_info info = CTE_INFO_INIT;
  cte_arguments arguments = CTE_ARGUMENTS_INIT;
  cte_batch batch = CTE_BATCH_INIT;
  cte_patch patch = CTE_PATCH_INIT;
  cte_api_table api = CTE_API_TABLE_INIT;
  int32_t index = -1;
  const bool found = cte_element_find("PointQuad4", 10, &index) == CTE_SUCCESS;
  const cte_element *element = cte_element_get(index);
  const bool described = found && cte_element_info(element, 0, &info) == CTE_SUCCESS && info.dimension == 3;
  const bool refused = cte_element_evaluate(element, &arguments) == CTE_ERROR_NULL &&
                       cte_element_evaluate_batch(element, 1, &batch) == CTE_ERROR_NULL &&
                       cte_patch_evaluate(&patch, &arguments) == CTE_ERROR_NODE_COUNT;
  const bool table = cte_api(CTE_VERSION_MAJOR, &api) == CTE_SUCCESS && api.version >= CTE_ABI_VERSION_COMPILED;
  std::printf("%s header.cpp\n", described && refused && table ? "PASS" : "FAIL");
  return described && refused && table ? 0 : 1;
}
