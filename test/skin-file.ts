import { NodeIO } from '@gltf-transform/core'
import type { Skin } from 'furrow/author'
import { accessorsOf } from './accessors.ts'
import { skinnedFile } from './skinned-file.ts'

export interface SkinFileOptions {
  mesh: string
  material: string
  /** Rotations about the x axis, radians, that an animation gives a joint. */
  animation?: { joint: string; angles: readonly number[] }
  /** Whether the whole model lies on its back, as if the file's upward axis was Z. */
  isLying?: boolean
}

/** Writes a skin with its skeleton as a `.glb` file. */
export async function skinFile(
  skin: Skin,
  { mesh, material, animation, isLying = false }: SkinFileOptions,
): Promise<Uint8Array> {
  const document = skinnedFile([{ name: mesh, material: { name: material, colour: [1, 1, 1] }, skin }])
  const root = document.getRoot()
  const [scene] = root.listScenes()
  const armature = document.createNode('Armature')
  if (isLying) armature.setRotation([Math.SQRT1_2, 0, 0, Math.SQRT1_2])
  for (const node of scene!.listChildren()) armature.addChild(node)
  scene!.addChild(armature)
  if (animation) {
    const accessor = accessorsOf(document)
    const { joint, angles } = animation
    const turned = angles.flatMap((angle) => [Math.sin(angle / 2), 0, 0, Math.cos(angle / 2)])
    const times = Float32Array.from(angles, (_, i) => i)
    const sampler = document
      .createAnimationSampler()
      .setInput(accessor('SCALAR', times))
      .setOutput(accessor('VEC4', Float32Array.from(turned)))
    const channel = document
      .createAnimationChannel()
      .setSampler(sampler)
      .setTargetNode(root.listNodes().find((node) => node.getName() === joint)!)
      .setTargetPath('rotation')
    document.createAnimation('move').addSampler(sampler).addChannel(channel)
  }
  return new NodeIO().writeBinary(document)
}
