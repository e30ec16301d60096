import { checkWrinkles, type Finding, type Glb, runKhronosValidator } from 'furrow-files'

/** Returns the findings of `furrow validate` for a file. */
export async function findingsOf(glb: Glb): Promise<Finding[]> {
  return [...(await checkWrinkles(glb)), ...(await runKhronosValidator(glb))]
}
