import { fileURLToPath } from 'node:url'
import type { AutoWrinkles, Skin, SkinJoint } from 'furrow/author'
import { DriverProgram, JointMeasurement, measuredSource, planDrivers } from 'furrow/internal'
import { documentOf, findSurfaces } from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import { Matrix4, Quaternion, Vector3 } from 'three'

/** Reads the skin of a model that ships. */
export async function shippedSkin(name: 'hand' | 'neck'): Promise<Skin> {
  const path = fileURLToPath(new URL(`../../../../../faces/${name}.glb`, import.meta.url))
  const document = await documentOf(await readGlbFile(path, 'test', {}), path, 'test')
  return findSurfaces(document, path, 'test', {}).surfaces[0]!.skin
}

/** Returns a skin whose joints are replaced. */
export function withJoints(skin: Skin, change: (joint: SkinJoint, index: number) => SkinJoint): Skin {
  const { skeleton } = skin
  return { ...skin, skeleton: { ...skeleton!, joints: skeleton!.joints.map(change) } }
}

/** Rotation of a joint about an axis in its rest frame, in radians. */
export type Bend = readonly [joint: string, axis: readonly [number, number, number], angle: number]

/** Returns a function that computes the activations of all areas of a posed skeleton. */
export function activationsOf(skin: Skin, { jointAreas }: Pick<AutoWrinkles, 'jointAreas'>) {
  const { joints } = skin.skeleton!
  const drivers = jointAreas.flatMap((area) => area.drivers)
  const names = joints.map(({ name }) => name)
  const binds = joints.map(({ bind }) =>
    new Matrix4().fromArray([...(bind as ArrayLike<number> as number[])]),
  )
  const plan = planDrivers([...drivers])
  const measurement = new JointMeasurement(plan.inputs.joint, names, () =>
    binds.flatMap(({ elements }) => elements),
  )
  const program = new DriverProgram(plan, { joint: measuredSource(measurement.missing) })
  return (bends: readonly Bend[]): Record<string, number> => {
    const posed: Matrix4[] = []
    for (const [i, { name, parent }] of joints.entries()) {
      const local = parent < 0 ? binds[i]!.clone() : binds[parent]!.clone().invert().multiply(binds[i]!)
      for (const [joint, axis, angle] of bends)
        if (joint === name)
          local.multiply(
            new Matrix4().makeRotationFromQuaternion(
              new Quaternion().setFromAxisAngle(new Vector3(...axis).normalize(), angle),
            ),
          )
      posed.push(parent < 0 ? local : posed[parent]!.clone().multiply(local))
    }
    const state = program.createState()
    measurement.measure(
      posed.flatMap(({ elements }) => elements),
      state.inputs.joint,
    )
    program.evaluate(state)
    return Object.fromEntries(plan.areaNames.map((name, i) => [name, state.activations[i]!]))
  }
}
