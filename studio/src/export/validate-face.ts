import type { Glb } from '../../../packages/cli/src/gltf/glb-file.ts'
import type { Finding } from '../../../packages/cli/src/validate/finding.ts'
import { runKhronosValidator } from '../../../packages/cli/src/validate/khronos.ts'
import { checkWrinkles } from '../../../packages/cli/src/wrinkles/rules.ts'

/** What is wrong with the wrinkles of a file, and with the rest of it, as `furrow validate` finds it. */
export async function findingsOf(glb: Glb): Promise<Finding[]> {
  return [...(await checkWrinkles(glb)), ...(await runKhronosValidator(glb))]
}
