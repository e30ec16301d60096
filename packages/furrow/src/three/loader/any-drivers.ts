import type { Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { VrmExpressions } from '../../drivers/morph/vrm.ts'
import { driversOf } from '../../drivers/of-type.ts'
import { planBy } from '../../drivers/plan.ts'
import { definitionOf, type WrinkleDriver } from '../../drivers/registry.ts'
import { bindPlan } from '../sources/bind-plan.ts'
import type { BindInputs, Drive, FetchTension } from '../sources/binding.ts'
import { bindTargets, bindTargetsBy } from '../sources/target.ts'

/**
 * Plans drivers of any type, and fetches what these read. Copies of the mesh share its geometry, and so its muscles.
 *
 * @param vrm of the file, if it is a VRM.
 */
export async function planDrivers(
  mesh: Mesh,
  drivers: readonly WrinkleDriver[],
  fetchTension: FetchTension,
  vrm: GLTFParser | undefined,
): Promise<Drive> {
  const muscles = driversOf('muscle', drivers)
  if (muscles.length > 0) (await import('../sources/muscles.ts')).addMuscles(mesh, muscles)
  const plan = planBy(definitionOf, drivers)
  const { inputs } = plan
  const bindings = {
    target: vrm ? await targetsOfVrm(mesh, vrm) : bindTargets,
    ...(inputs.joint.length > 0 && { joint: (await import('../sources/joint.ts')).bindJoints }),
    ...(inputs.tension.length > 0 && { tension: await fetchTension() }),
  }
  return (own, file) => {
    const expressions = () => (vrm && file ? expressionsOf(file) : undefined)
    const runtime = bindPlan(own, { drivers, plan, bindings }, () => ({ expressions: expressions() }))
    // three-vrm may create a VRM's expressions after this: they are looked up when the face is first drawn.
    if (!vrm || !file) runtime.bind()
  }
}

/** Where three-vrm's plugins put the expressions. */
function expressionsOf({ userData }: GLTF): VrmExpressions | undefined {
  return userData.vrmExpressionManager ?? userData.vrm?.expressionManager
}

async function targetsOfVrm(mesh: Mesh, { json, associations }: GLTFParser): Promise<BindInputs<'target'>> {
  const index = associations.get(mesh)?.meshes
  if (index === undefined) return bindTargets
  const { combinableTargets } = await import('../sources/combined-targets.ts')
  return bindTargetsBy(combinableTargets(json, index))
}
