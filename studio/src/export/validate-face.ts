import { checkWrinkles, type Finding, type Glb, runKhronosValidator } from 'furrow-files'

/** What is wrong with the wrinkles of a file, and with the rest of it, as `furrow validate` finds it. */
export async function findingsOf(glb: Glb): Promise<Finding[]> {
  return [...(await checkWrinkles(glb)), ...(await runKhronosValidator(glb))]
}
